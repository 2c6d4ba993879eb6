# The pictures of handouts/engine.md, by the last step's program: what a frame of the gallery makes, in its order.
step=12-gallery
preview=(--scene gallery --eye 0,1.6,517.35 --target 0,1.6,514.85)

# The three drawings of two previews.
size=200x200
tiles=()
for room in 4 3; do
  for output in colour relief relief_height; do
    plain engine-$room-$output $step "${preview[@]}" --set gallery.room=$room --output $output
    tiles+=("engine-$room-$output=room $room, $output")
  done
done
sheet engine-previews 3 "${tiles[@]}"

# The frame: without previews, with them, with their relief.
size=320x240
plain engine-bare $step --scene gallery --set preview.most=0
plain engine-flat $step --scene gallery --set preview.relief=off
plain engine-relief $step --scene gallery
sheet engine-hall 3 engine-bare="preview.most=0" engine-flat="preview.relief=off" engine-relief="preview.relief=on"

# What step 01 and step 05 hand to the light: positions, normals.
plain engine-position $step --scene gallery --output position
plain engine-normal $step --scene gallery --output normal
pair engine-surfaces engine-position engine-normal
