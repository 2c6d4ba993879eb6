draw --scene gallery --set parallax.layers=64
# The walk through all rooms: two pictures for each second of it.
film=$(mktemp --suffix .gif)
"$build/bin/$step" --implementations "$build/implementations/solutions:solutions" --size 200x150 --record "$film" \
  --frames 98 --vary walk.seconds=0.5..49 --scene gallery >/dev/null
convert "$film" -coalesce -set delay 15 -dither FloydSteinberg -colors 96 -layers optimize docs/pictures/walk.gif
rm "$film"
