size=400x300
draw 07-rooms $step --scene rooms && single 07-rooms
draw 07-mirror $step --scene mirror && single 07-mirror
draw 07-tilted $step --scene rolled && single 07-tilted
draw 07-corridor $step --scene corridor --set portals.depth=60 && single 07-corridor
draw 07-alley $step --scene alley && single 07-alley
size=300x225
draw without $step --scene rooms --set portals.clip=none && draw with $step --scene rooms && pair 07-not-clipped without with
draw before $step --scene rooms --set visitor.way=0.8333 && draw after $step --scene rooms --set visitor.way=0.8334 && pair 07-crossing before after
lamp=(--scene lamp --set portals.lights=on --set shadow.filter=bilinear)
draw 07-off $step --scene lamp --set shadow.filter=bilinear && draw 07-on $step "${lamp[@]}" && truth 07-truth $step "${lamp[@]}"
sheet 07-lamp 3 07-off="portals.lights=off" 07-on="portals.lights=on" 07-truth=truth
for way in 0.35 0.5 0.65; do draw astride-$way $step --scene astride --set portals.lights=on --set body.way=$way; done
sheet 07-astride 3 astride-0.35="body.way=0.35" astride-0.5="body.way=0.5" astride-0.65="body.way=0.65"
mistakes $step 07-mistakes room-seen--{half-turn-missing,view-passage-itself} corridor-end--restore-not-closed tilted--{half-turn-outside,transposed-for-inverse} covered--restore-no-depth

# The visitor's walk.
(cd "$root" && "$build/bin/$step" --implementations "$build/implementations/solutions:solutions" --scene rooms \
  --size 240x180 --record "$out/07-walk.gif" --frames 32 --vary visitor.way=0..1 --set frame.supersampling=3)

# One period of the particles.
(cd "$root" && "$build/bin/$step" --implementations "$build/implementations/solutions:solutions" --scene swirl \
  --size 320x240 --record "$out/07-swirl.gif" --frames 24 --vary particles.time=0..1 --set frame.supersampling=3)
