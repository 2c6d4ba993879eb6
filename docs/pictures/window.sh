#!/usr/bin/env bash
# Takes window.png again: the window of step 12 in the painterly room, after a few steps. Needs xvfb, xdotool and
# ImageMagick. ATELIER_BUILD names another build folder than build/release.
set -euo pipefail

[[ -n ${ATELIER_DISPLAY:-} ]] || exec env ATELIER_DISPLAY=1 LIBGL_ALWAYS_SOFTWARE=1 \
  xvfb-run -s "-screen 0 920x480x24" "${BASH_SOURCE[0]}"

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=${ATELIER_BUILD:-$root/build/release}
cd "$root"
"$build/bin/12-gallery" --implementations "$build/implementations/solutions:solutions" --scene gallery --size 640x480 \
  --set gallery.room=2 >/dev/null &
program=$!
trap 'kill "$program"' EXIT
sleep 5
xdotool windowfocus "$(xdotool search --pid "$program" | tail -1)"
for _ in {1..4}; do xdotool key Up && sleep 0.2; done
sleep 1
import -window root docs/pictures/window.png
mogrify -resize 690x360 +dither -colors 200 -define png:exclude-chunks=date,time docs/pictures/window.png
