#!/usr/bin/env bash
# Draws the handouts' pictures again with the finished solutions, after a step's scenes have changed.
#
#   handouts/pictures/make.sh [NN...]     the pictures of these steps; without one: of all (needs ImageMagick and jq)
#
# Which pictures a step has stands beside this file in NN-name.sh: calls of the functions below, with the step's name in
# $step and pictures of $size. ATELIER_BUILD names another build folder than build/release.
#
# The small pictures of mistakes are those that the judge compares answers with: tests/cases/*/references/*.atlas.png.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=${ATELIER_BUILD:-$root/build/release}
out=$root/handouts/pictures
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

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

for number in "${@:-}"; do
  scripts=("$out/$number"*-*.sh)
  [[ -e ${scripts[0]} ]] || { echo "error: step '$number': $out has no $number-*.sh" >&2; exit 2; }
  for script in "${scripts[@]}"; do
    step=$(basename "$script" .sh) size=320x240
    # shellcheck source=/dev/null
    source "$script"
  done
done
