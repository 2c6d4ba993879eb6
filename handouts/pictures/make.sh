#!/usr/bin/env bash
# Draws the handouts' pictures again with the finished solutions, after a step's scenes have changed.
#
#   handouts/pictures/make.sh [BUILD_FOLDER]     (build/release by default; needs ImageMagick)
#
# The small pictures of mistakes are those that the judge compares answers with: tests/cases/*/atlas.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=${1:-$root/build/release}
out=$root/handouts/pictures
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

size=320x240

# draw NAME STEP ARGUMENTS...: one picture into the scratch folder
draw() {
  local name=$1 step=$2
  shift 2
  (cd "$root" && "$build/bin/$step" --implementations "$build/implementations/solutions:solutions" --size "$size" \
    --out "$scratch/$name.png" "$@" >/dev/null)
}

single() { cp "$scratch/$1.png" "$out/$1.png"; }

# pair NAME LEFT RIGHT
pair() { convert "$scratch/$2.png" "$scratch/$3.png" -background white +smush 8 "$out/$1.png"; }

# mistakes STEP NAME CASE--MISTAKE...: a labelled sheet
mistakes() {
  local step=$1 name=$2 tile arguments=()
  shift 2
  for tile in "$@"; do arguments+=(-label "${tile#*--}" "$root/tests/cases/$step/atlas/$tile.png"); done
  montage -font DejaVu-Sans -pointsize 9 -geometry 104x104+3+3 -tile 4x "${arguments[@]}" "$scratch/$name.png"
  convert "$scratch/$name.png" +dither -colors 255 "PNG8:$out/$name.png"
}

draw 00-triangle 00-hello && single 00-triangle

step=01-transforms
draw 01-triangle $step --scene triangle && single 01-triangle
draw 01-wireframe $step --scene teapot --set draw.wireframe=on && single 01-wireframe
draw robot $step --scene robot && draw spiral $step --scene spiral && pair 01-hierarchy robot spiral
draw teapot $step --scene teapot && draw plan $step --scene plan && pair 01-camera teapot plan
draw stretched $step --scene stretched && draw normal $step --scene stretched --output normal
pair 01-normals stretched normal
draw hall $step --scene hall && draw prism $step --scene hall --set hall.segments=3 && pair 01-hall hall prism
draw usual $step --scene slats && draw reversed $step --scene slats --set depth.format=32f-reversed
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
draw linear $step --scene tiles --set texture.filter=linear && draw mipmap $step --scene tiles
pair 02-tiles linear mipmap
size=320x240
draw plain $step --scene materials && draw normalised $step --scene materials --set specular.normalisation=n+8
pair 02-materials plain normalised
draw pixel $step --scene facets && draw vertex $step --scene facets --set shading=vertex && pair 02-facets pixel vertex
mistakes $step 02-mistakes sphere--{eye-at-origin,missing-n-dot-l,no-attenuation,rv-for-nh} \
  facets--normal-not-normalised backlight--specular-from-behind spots--{cone-inverted,cone-axis-sign,cone-hard} \
  lights--lights-overwrite tiles--{no-mipmaps,texture-upside-down} encoded--{gamma-missing,gamma-twice} \
  copper--specular-grey sphere--to-light-reversed
