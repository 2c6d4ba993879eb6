draw 01-triangle $step --scene triangle && single 01-triangle
plain 01-wireframe $step --scene teapot --set draw.wireframe=on && single 01-wireframe
draw robot $step --scene robot && draw spiral $step --scene spiral && pair 01-hierarchy robot spiral
draw teapot $step --scene teapot && draw plan $step --scene plan && pair 01-camera teapot plan
draw stretched $step --scene stretched && draw normal $step --scene stretched --output normal
pair 01-normals stretched normal
draw hall $step --scene hall && draw prism $step --scene hall --set hall.segments=3 && pair 01-hall hall prism
plain usual $step --scene slats && plain reversed $step --scene slats --set depth.format=32f-reversed
pair 01-slats usual reversed
draw far $step --scene far --set world.offset=1000000
draw near $step --scene far --set world.offset=1000000 world.camera_relative=on
pair 01-far far near
mistakes $step 01-mistakes robot--{matrix-order,parent-order,only-parent,compose-order,rotation-backwards} \
  robot--{fov-not-halved,mirrored-view,view-axes-as-columns,offset-in-row,position-w-zero,stride,attribute-not-enabled}
