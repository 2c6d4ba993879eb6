size=240x180
for turn in 0 0.1667 0.3333 0.5 0.6667 0.8333; do draw 08-turn-$turn $step --scene chart --set colour.hue=$turn; done
sheet 08-hue 3 08-turn-0="colour.hue=0" 08-turn-0.1667="1/6" 08-turn-0.3333="1/3" 08-turn-0.5="1/2" 08-turn-0.6667="2/3" 08-turn-0.8333="5/6"
for factor in 0 0.5 1 1.8; do draw 08-chroma-$factor $step --scene chart --set colour.saturation=$factor; done
sheet 08-saturation 2 08-chroma-0="colour.saturation=0" 08-chroma-0.5="0.5" 08-chroma-1="1" 08-chroma-1.8="1.8"

# What a mistake makes of a case is in the case's atlas, half as large as the case. Flat patches: enlarged as they are.
tile_of_atlas $step chart-turned gamut-clamped
size=160x120 draw 08-shrunk $step --scene chart --set colour.hue=0.3333
mogrify -filter point -resize 200% "$scratch/chart-turned--gamut-clamped.png" "$scratch/08-shrunk.png"
pair 08-gamut chart-turned--gamut-clamped 08-shrunk

for curve in none reinhard filmic; do draw 08-$curve $step --scene lanterns --set tone.curve=$curve; done
sheet 08-curves 3 08-none="tone.curve=none" 08-reinhard=reinhard 08-filmic=filmic

# The blur's width is in pixels of the supersampled picture: three times as many.
glow=(--scene lanterns --set bloom.strength=0.5 --set bloom.sigma=18)
draw 08-bright $step "${glow[@]}" --output bright
draw 08-blur $step "${glow[@]}" --output blur
draw 08-glowing $step "${glow[@]}" --set tone.curve=filmic
sheet 08-bloom 2 08-filmic="without bloom" 08-bright="--output bright" 08-blur="--output blur" 08-glowing="bloom.strength=0.5"

size=400x300
draw 08-overlay $step --scene room --set overlay.amount=1 && single 08-overlay
size=240x180
for look in none warm night; do draw 08-$look-look $step --scene room --set table.look=$look; done
sheet 08-tables 3 08-none-look="table.look=none" 08-warm-look=warm 08-night-look=night

# Single codes of 8 bits: no supersampling, and more contrast than they have.
size=320x240
plain 08-banded $step --scene ramp --set frame.format=8
plain 08-dithered $step --scene ramp --set frame.format=8 --set chain.dither=on
part 160x110+80+15 08-banded 08-dithered
mogrify -level 3%,25% -filter point -resize 200% "$scratch/08-banded.png" "$scratch/08-dithered.png"
pair 08-bands 08-banded 08-dithered

mistakes $step 08-mistakes chart-turned--{hue-sectors-exchanged,colour-value-for-luma} chart-vivid--saturation-on-components \
  chart-bright--adjust-luma-added lanterns-filmic--filmic-not-normalised room-overlay--overlay-inverted \
  lanterns-blur--blur-not-mirrored chart-warm--cube-blue-first

# The hue goes round once.
(cd "$root" && "$build/bin/$step" --implementations "$build/implementations/solutions:solutions" --scene room \
  --size 240x180 --record "$out/08-hue-turn.gif" --frames 16 --vary colour.hue=0..1 --set frame.supersampling=3)
