draw 03-teapot $step --scene teapot --set shadow.fit=casters && single 03-teapot
draw 03-edges $step --scene edges && single 03-edges
plain stripes $step --scene grazing --set shadow.bias=none shadow.resolution=128
plain moire $step --scene teapot --set shadow.bias=none && pair 03-acne stripes moire
draw contact $step --scene table --set shadow.resolution=256 shadow.bias=constant shadow.bias_size=2
draw gap $step --scene table --set shadow.resolution=256 shadow.bias=constant shadow.bias_size=16
pair 03-panning contact gap

size=180x180
draw map $step --scene teapot --set shadow.fit=casters --output shadow_map
size=240x180
for output in shadow_coordinate shadow_factor colour; do
  draw $output $step --scene teapot --set shadow.fit=casters --output $output
done
sheet 03-stages 4 map=shadow_map shadow_coordinate shadow_factor colour

size=480x360
for bias in none constant slope normal plane front-faces; do
  draw $bias $step --scene table --set shadow.resolution=128 shadow.bias=$bias
done
draw fine $step --scene table --set shadow.resolution=512 && truth table-truth $step --scene table
part 240x180+110+40 none constant slope normal plane front-faces fine table-truth
sheet 03-biases 4 none constant slope normal plane front-faces fine="normal, 512 texels" table-truth=truth
filter() { draw "$1" $step --scene table --set shadow.resolution=256 "${@:2}"; }
filter nearest && filter bilinear shadow.filter=bilinear
filter pcf5 shadow.pcf=5 && filter both shadow.pcf=5 shadow.filter=bilinear
part 240x150+0+160 nearest bilinear pcf5 both
sheet 03-filters 4 nearest bilinear pcf5="nearest, 5 x 5" both="bilinear, 5 x 5"
soft() { "$1" "$2" $step --scene table --set light.width=0.4 "${@:3}"; }
soft draw fixed shadow.pcf=15 && soft draw pcss shadow.soft=pcss shadow.samples=64
soft plain random shadow.soft=pcss shadow.samples=64 shadow.pattern=random && soft truth soft-truth
part 240x150+0+160 fixed pcss random soft-truth
sheet 03-soft 4 fixed="pcf, 15 x 15" pcss="pcss, grid of 64" random="pcss, 64 random" soft-truth=truth

size=240x180
across=(--scene colonnade --eye 1,1.7,1.9 --target -1.6,0.2,1.2)
for fit in scene casters visible; do
  draw $fit $step "${across[@]}" --set shadow.fit=$fit
  size=180x180 draw map-$fit $step "${across[@]}" --set shadow.fit=$fit --output shadow_map
done
sheet 03-fits 3 map-scene="map of scene" map-casters="of casters" map-visible="of visible" scene casters visible
mistakes $step 03-mistakes teapot--{bias-matrix-missing,border-black,border-repeats,camera-depth} \
  teapot--{cleared-to-zero,comparison-reversed,depth-model-missing,far-not-clamped} \
  teapot--{no-w-divide,normal-offset-inwards,unbiased-lookup} edges--depth-not-halved \
  three-spots--{layer-zero-drawn,layer-zero-read} colonnade--{sun-perspective,sun-eye-at-centre}

# The light goes round.
(cd "$root" && "$build/bin/$step" --implementations "$build/implementations/solutions:solutions" --scene three-spots \
  --size 240x180 --record "$out/03-light-turn.gif" --frames 36 --vary light.turn=0..360 \
  --eye 1.8,3.6,5.6 --target 0,0.8,0 --set shadow.filter=bilinear shadow.pcf=3 frame.supersampling=3)
