# Strokes, and lines from neighbours, are as broad as pixels say: one sample each. Lenses are drawn without stairs.
painterly=(--set style.first=painterly)
toon=(--set style.first=toon)
fisheye=(--set style.first=fisheye)
cube=("${fisheye[@]}" --set fisheye.lens=equidistant --set fisheye.from=cube)

# Every style on three scenes.
size=180x135
small=("${painterly[@]}" --set paint.grid=5 --set paint.largest=4)
tiles=()
for scene in still-life teapot room; do
  plain 10-$scene-painterly $step --scene $scene "${small[@]}"
  plain 10-$scene-confined $step --scene $scene "${small[@]}" --set paint.confined=on
  plain 10-$scene-toon $step --scene $scene "${toon[@]}"
  plain 10-$scene-surface $step --scene $scene "${toon[@]}" --set toon.outlines=surface
  draw 10-$scene-fisheye $step --scene $scene "${fisheye[@]}"
  draw 10-$scene-cube $step --scene $scene "${cube[@]}"
  draw 10-$scene-aberration $step --scene $scene --set style.first=aberration
  tiles+=("10-$scene-painterly=painterly" "10-$scene-confined=paint.confined=on" "10-$scene-toon=toon"
    "10-$scene-surface=toon.outlines=surface" "10-$scene-fisheye=fisheye" "10-$scene-cube=180 degrees, cube"
    "10-$scene-aberration=aberration")
done
sheet 10-styles 7 "${tiles[@]}"

size=240x180
tiles=()
for outlines in none colour surface both; do
  plain 10-toon-$outlines $step --scene still-life "${toon[@]}" --set toon.outlines=$outlines
  tiles+=("10-toon-$outlines=toon.outlines=$outlines")
done
sheet 10-toon 2 "${tiles[@]}"

tiles=()
for power in 1 2 4; do
  draw 10-power-$power $step --scene room "${fisheye[@]}" --set fisheye.power=$power
  tiles+=("10-power-$power=fisheye.power=$power")
done
sheet 10-power 3 "${tiles[@]}"

# From the middle of the room.
tiles=()
for angle in 180 270 360; do
  draw 10-around-$angle $step --scene room --eye 0,1.5,0.4 --target 0,1.4,-1 "${cube[@]}" --set fisheye.angle=$angle
  tiles+=("10-around-$angle=fisheye.angle=$angle")
done
sheet 10-all-around 3 "${tiles[@]}"

size=320x240
for outlines in colour surface; do
  plain 10-blocks-$outlines $step --scene blocks "${toon[@]}" --set toon.outlines=$outlines
done
pair 10-surface 10-blocks-colour 10-blocks-surface

tiles=()
for iterations in 1 4 15; do
  plain 10-iterations-$iterations $step --scene still-life "${painterly[@]}" --set paint.iterations=$iterations
  tiles+=("10-iterations-$iterations=paint.iterations=$iterations")
done
sheet 10-iterations 3 "${tiles[@]}"

plain 10-within $step --scene still-life "${painterly[@]}" --set paint.confined=on
pair 10-confined 10-iterations-15 10-within

draw 10-relief-plain $step --scene still-life --output relief
draw 10-relief-lens $step --scene still-life --output relief "${fisheye[@]}"
pair 10-relief 10-relief-plain 10-relief-lens

mistakes $step 10-mistakes toon-room--{edge-of-luma,toon-not-squared,toon-five-greys} \
  blocks-surface--steps-four-neighbours room-power--power-aspect-ignored room-all-around--fisheye-rectilinear \
  room-aberrated--aberration-same-phase card-painted--stroke-endless
