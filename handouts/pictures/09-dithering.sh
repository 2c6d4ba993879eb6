# All of this is about single pixels: one sample each, and enlarged only by whole numbers.
one_bit=(--scene deck --set dither.method=bayer --set dither.grey=on)

# The original, then 2, 3 and 4 levels; encoded above, linear below.
size=160x120
plain 09-card $step --scene card
tiles=()
for space in encoded linear; do
  tiles+=(09-card=original)
  for levels in 2 3 4; do
    plain 09-$space-$levels $step --scene card --set dither.method=floyd-steinberg --set dither.levels=$levels \
      --set dither.space=$space
    tiles+=("09-$space-$levels=$space, $levels levels")
  done
done
sheet 09-space 4 "${tiles[@]}"

# Every method on three scenes, with 2 and 3 levels.
size=240x180
for scene in teapot deck room; do
  tiles=()
  for levels in 2 3; do
    for method in none rounded bayer blue-noise floyd-steinberg atkinson; do
      plain 09-$scene-$method-$levels $step --scene $scene --set dither.method=$method --set dither.levels=$levels
      tiles+=("09-$scene-$method-$levels=$method, $levels levels")
    done
  done
  tiles[0]=09-$scene-none-2=none tiles[6]=09-$scene-none-3=none
  sheet 09-$scene 3 "${tiles[@]}"
done

# The three ways to hold the pattern, from two places.
tiles=()
for eye in 0.2,1.65,3.6 0.5,1.65,3.3; do
  for held in screen sphere world; do
    plain 09-$held-$eye $step "${one_bit[@]}" --set dither.held=$held --eye $eye --target 0,0.8,-3
    tiles+=("09-$held-$eye=dither.held=$held")
  done
done
sheet 09-held 3 "${tiles[@]}"

size=320x240
plain 09-black-lines $step --scene deck --set dither.lines=black
plain 09-white-lines $step "${one_bit[@]}" --set dither.held=sphere --set dither.lines=white
pair 09-lines 09-black-lines 09-white-lines

# A part of the teapot, three times as large.
tiles=()
for method in bayer blue-noise floyd-steinberg atkinson; do
  plain 09-bits-$method $step --scene teapot --set dither.method=$method --set dither.grey=on
  part 120x90+100+75 09-bits-$method
  mogrify -filter point -resize 300% "$scratch/09-bits-$method.png"
  tiles+=(09-bits-$method=$method)
done
sheet 09-patterns 2 "${tiles[@]}"

mistakes $step 09-mistakes card-bayer--bayer-quarters-exchanged card-bayer-four--level-steps-of-count \
  card-floyd--{error-overwritten,shares-exchanged} card-serpentine--serpentine-half deck-sphere--cube-flat \
  deck-lines--edge-degrees deck-world--octave-other-size

# The camera goes round once.
(cd "$root" && "$build/bin/$step" --implementations "$build/implementations/solutions:solutions" --scene teapot \
  --size 240x180 --record "$out/09-teapot-turn.gif" --frames 24 --set dither.method=floyd-steinberg \
  --set dither.levels=3)
