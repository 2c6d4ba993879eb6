#!/usr/bin/env bash
# Draws the README's pictures again with the finished solutions.
#
#   docs/pictures/make.sh [NN...]     the pictures of these steps; without one: all, and the hall (which needs ImageMagick)
#
# How a step's picture is drawn stands beside this file in NN-name.sh. ATELIER_BUILD names another build folder than
# build/release.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=${ATELIER_BUILD:-$root/build/release}
cd "$root"

# draw ARGUMENTS...: docs/pictures/$name.png by $step
draw() {
  "$build/bin/$step" --implementations "$build/implementations/solutions:solutions" --size "$size" \
    --out "docs/pictures/$name.png" "$@" --set frame.supersampling=4 >/dev/null
}

for number in "${@:-}"; do
  scripts=("docs/pictures/$number"*-*.sh)
  [[ -e ${scripts[0]} ]] || { echo "error: step '$number': docs/pictures has no $number-*.sh" >&2; exit 2; }
  for script in "${scripts[@]}"; do
    step=$(basename "$script" .sh)
    name=$step size=240x180
    # shellcheck source=/dev/null
    source "$script"
  done
done
if (($# == 0)); then
  step=02-blinn-phong name=hall size=880x440
  draw --scene hall
  # Large and full of detail: 256 colours are a third of the bytes.
  convert docs/pictures/hall.png -dither FloydSteinberg -colors 256 -define png:exclude-chunks=date,time \
    "PNG8:docs/pictures/hall.png"
fi
