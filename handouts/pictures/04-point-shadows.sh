draw front $step --scene lantern && draw behind $step --scene lantern --set view.turn=140 && pair 04-lantern front behind
size=360x240
draw 04-faces $step --scene lantern --output shadow_map --set cube.resolution=256 && single 04-faces
size=320x240
draw crates $step --scene crates && draw factor $step --scene crates --output shadow_factor && pair 04-crates crates factor
draw 04-desk $step --scene desk && single 04-desk
draw 04-touching $step --scene touching && single 04-touching
mistakes $step 04-mistakes lantern--{up-vectors,faces-exchanged,layer-zero,last-face-left-out} \
  lantern--{lamp-minus-point,depth-along-axis,viewport-missing,far-forgotten,beyond-far-dark} \
  lantern-behind--end-primitive-missing crates--{comparison-reversed,distance-not-divided,distance-squared} \
  room--{texel-half,looks-at-axis} pcf-4--pcf-in-one-plane
