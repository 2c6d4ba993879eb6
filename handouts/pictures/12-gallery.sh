# Eyes on a circle of 3 m around the axis; painting 0 is at -z, the next ones follow counter-clockwise from above.
eyes=(0,1.6,-3 -2.598,1.6,-1.5 -2.598,1.6,1.5 0,1.6,3 2.598,1.6,1.5 2.598,1.6,-1.5)
targets=(0,1.6,-6 -5.196,1.6,-3 -5.196,1.6,3 0,1.6,6 5.196,1.6,3 5.196,1.6,-3)
styles=(none floyd_steinberg painterly fisheye toon aberration)

# Each painting from 3 m before the wall.
size=240x180
tiles=()
for room in {0..5}; do
  draw 12-painting-$room $step --scene gallery --eye "${eyes[room]}" --target "${targets[room]}"
  tiles+=("12-painting-$room=${styles[room]}")
done
sheet 12-paintings 3 "${tiles[@]}"

# The rooms themselves. A stroke, a dot or an outline is as broad as pixels say: one sample each.
tiles=()
for room in {0..5}; do
  plain 12-room-$room $step --scene gallery --set gallery.room=$room
  tiles+=("12-room-$room=gallery.room=$room")
done
sheet 12-rooms 3 "${tiles[@]}"

size=480x320
draw 12-hall $step --scene gallery && single 12-hall

size=240x180
tiles=()
for segments in 6 16 64; do
  draw 12-segments-$segments $step --scene gallery --set preview.most=0 --set hall.segments=$segments
  tiles+=("12-segments-$segments=hall.segments=$segments")
done
sheet 12-segments 3 "${tiles[@]}"

# A portal beside a preview without relief: from the preview's own place, and from another one.
plain=(--scene gallery --set parallax.method=none)
place=(--eye 0,1.6,-3.2214 --target 0,1.6,-5.7214)
elsewhere=(--eye 1.6,1.6,-3.6 --target 0,1.6,-5.7214)
tiles=()
for where in place elsewhere; do
  declare -n camera=$where
  draw 12-portal-$where $step "${plain[@]}" --set gallery.portals=1 "${camera[@]}"
  draw 12-preview-$where $step "${plain[@]}" "${camera[@]}"
  tiles+=("12-portal-$where=gallery.portals=1" "12-preview-$where=gallery.portals=0")
done
unset -n camera
sheet 12-portal-preview 2 "${tiles[@]}"

size=320x240
draw 12-left $step --scene gallery --eye -1.8,1.6,-3.9 --target 0,1.6,-5.7 --set parallax.layers=128
draw 12-right $step --scene gallery --eye 1.8,1.6,-3.9 --target 0,1.6,-5.7 --set parallax.layers=128
pair 12-sides 12-left 12-right

# What is recorded of a room with and without a lens.
size=200x200
tiles=()
for room in 0 3; do
  for output in colour relief relief_height; do
    plain 12-map-$room-$output $step --scene gallery --set gallery.room=$room --output $output \
      --eye 0,1.6,517.35 --target 0,1.6,514.85
    tiles+=("12-map-$room-$output=room $room, $output")
  done
done
sheet 12-maps 3 "${tiles[@]}"

mistakes $step 12-mistakes hall--{wall-inside-out,wall-normals,painting-axis-reversed} \
  previews--{preview-angle,preview-before-exit,record-always-colour} painting-toon--{style-off-by-one,paintings-clockwise}
