#!/usr/bin/env bash
# Draws the README's pictures again with the finished solutions.
#
#   docs/pictures/make.sh [BUILD_FOLDER]     (build/release by default; needs ImageMagick)
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=${1:-$root/build/release}
cd "$root"

# draw NAME STEP SIZE ARGUMENTS...
draw() {
  local name=$1 step=$2 size=$3
  shift 3
  "$build/bin/$step" --implementations "$build/implementations/solutions:solutions" --size "$size" \
    --out "docs/pictures/$name.png" "$@" --set frame.supersampling=4 >/dev/null
}

draw 00-hello 00-hello 240x180
draw 01-transforms 01-transforms 240x180 --scene robot
draw 02-blinn-phong 02-blinn-phong 240x180 --scene lights
draw 03-shadow-mapping 03-shadow-mapping 240x180 --scene colonnade
draw 04-point-shadows 04-point-shadows 240x180 --scene lantern --set view.turn=30
draw hall 02-blinn-phong 880x440 --scene hall
# Large and full of detail: 256 colours are a third of the bytes.
convert docs/pictures/hall.png -dither FloydSteinberg -colors 256 "PNG8:docs/pictures/hall.png"
mogrify -define png:exclude-chunks=date,time docs/pictures/*.png  # the same picture is the same file
