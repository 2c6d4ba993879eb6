#!/usr/bin/env bash
# Draws the handouts' pictures again with the finished solutions, after a step's scenes have changed.
#
#   handouts/pictures/make.sh [BUILD_FOLDER]     (build/release by default; needs ImageMagick and jq)
#
# One is an animation: the light that goes round in step 03.
#
# The small pictures of mistakes are those that the judge compares answers with: tests/cases/*/references/*.atlas.png.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=${1:-$root/build/release}
out=$root/handouts/pictures
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

size=320x240
same=(-define png:exclude-chunks=date,time) # the same picture is the same file

# plain NAME STEP ARGUMENTS...: one picture into the scratch folder, as the judge sees it: one sample a pixel. For
# pictures that are about single pixels: noise, moire, wires, what a texture filter leaves.
plain() {
  local name=$1 step=$2
  shift 2
  (cd "$root" && "$build/bin/$step" --implementations "$build/implementations/solutions:solutions" --size "$size" \
    --out "$scratch/$name.png" "$@" >/dev/null)
}

# draw NAME STEP ARGUMENTS...: the same without stairs along edges
draw() { plain "$@" --set frame.supersampling=3; }
# truth NAME STEP ARGUMENTS...: traced, without stairs
truth() { plain "$@" --truth --samples 3; }

single() { cp "$scratch/$1.png" "$out/$1.png"; }

# pair NAME LEFT RIGHT
pair() { convert "$scratch/$2.png" "$scratch/$3.png" -background white +smush 8 "${same[@]}" "$out/$1.png"; }

# sheet NAME COLUMNS PICTURE=LABEL...: a labelled sheet of pictures of one size
sheet() {
  local name=$1 columns=$2 tile arguments=()
  shift 2
  for tile in "$@"; do arguments+=(-label "${tile#*=}" "$scratch/${tile%%=*}.png"); done
  montage -font DejaVu-Sans -pointsize 11 -geometry +3+3 -tile "${columns}x" "${arguments[@]}" "${same[@]}" "$out/$name.png"
}

# part GEOMETRY NAME...: what remains of pictures
part() {
  local geometry=$1 name
  shift
  for name in "$@"; do mogrify -crop "$geometry" +repage "$scratch/$name.png"; done
}

# tile_of_atlas STEP CASE MISTAKE: the mistake's picture out of the case's atlas, as $scratch/CASE--MISTAKE.png
tile_of_atlas() {
  local folder="$root/tests/cases/$1/references" count row
  count=$(jq '.atlas | length' "$folder/$2.json")
  row=$(jq --arg mistake "$3" '.atlas | index($mistake)' "$folder/$2.json")
  [[ $row != null ]] || { echo "$folder/$2.json: its atlas has no '$3'" >&2; exit 1; }
  convert "$folder/$2.atlas.png" -crop "1x$count@" +repage "$scratch/atlas-%d.png"
  mv "$scratch/atlas-$row.png" "$scratch/$2--$3.png"
}

# mistakes STEP NAME CASE--MISTAKE...: a labelled sheet
mistakes() {
  local step=$1 name=$2 tile arguments=()
  shift 2
  for tile in "$@"; do
    tile_of_atlas "$step" "${tile%%--*}" "${tile#*--}" && arguments+=(-label "${tile#*--}" "$scratch/$tile.png")
  done
  montage -font DejaVu-Sans -pointsize 9 -geometry 104x104+3+3 -tile 4x "${arguments[@]}" "$scratch/$name.png"
  convert "$scratch/$name.png" +dither -colors 255 "${same[@]}" "PNG8:$out/$name.png"
}

draw 00-triangle 00-hello && single 00-triangle

step=01-transforms
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

step=02-blinn-phong
draw 02-sphere $step --scene sphere && single 02-sphere
draw 02-teapot $step --scene teapot && single 02-teapot
draw 02-edges $step --scene edges && single 02-edges
draw diffuse $step --scene sphere --output diffuse && draw specular $step --scene sphere --output specular
pair 02-parts diffuse specular
draw spots $step --scene spots && draw lights $step --scene lights && pair 02-lights spots lights
size=256x192 # fine detail all over: larger ones would weigh over 100 kB
plain linear $step --scene tiles --set texture.filter=linear && plain mipmap $step --scene tiles
pair 02-tiles linear mipmap
size=320x240
draw plain $step --scene materials && draw normalised $step --scene materials --set specular.normalisation=n+8
pair 02-materials plain normalised
draw pixel $step --scene facets && draw vertex $step --scene facets --set shading=vertex && pair 02-facets pixel vertex
draw blind-lamp $step --scene blinds --set light.blind=on light.count=1
draw blinds $step --scene blinds --set light.blind=on && pair 02-blinds blind-lamp blinds
mistakes $step 02-mistakes sphere--{eye-at-origin,missing-n-dot-l,no-attenuation,rv-for-nh} \
  facets--normal-not-normalised backlight--specular-from-behind spots--{cone-inverted,cone-axis-sign,cone-hard} \
  lights--lights-overwrite tiles--{no-mipmaps,texture-upside-down} encoded--{gamma-missing,gamma-twice} \
  copper--specular-grey sphere--to-light-reversed \
  blinds--{visibility-ignored,ambient-shadowed,first-lights-shadow,shadows-multiplied}

step=03-shadow-mapping
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

step=04-point-shadows
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
