#!/usr/bin/env bash
# Takes report.png again: the report of a known mistake in step 05, in a browser. Needs chromium and ImageMagick.
# ATELIER_BUILD names another build folder than build/release.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=${ATELIER_BUILD:-$root/build/release}
step=05-normal-mapping
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

mkdir ada-lovelace
cp -r "$root/solutions/$step" ada-lovelace/
patch -d "ada-lovelace/$step" -p1 -s <"$root/tests/mistakes/$step/u-v-exchanged.patch"
"$build/bin/atelier" grade ada-lovelace --out report >/dev/null
chromium --headless --no-sandbox --hide-scrollbars --window-size=1280,880 --screenshot=shot.png \
  "file://$work/report/report.html" 2>/dev/null
convert shot.png -dither None -colors 256 -define png:exclude-chunks=date,time "PNG8:$root/docs/pictures/report.png"
