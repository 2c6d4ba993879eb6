# One sample a pixel: a stroke's width is in pixels, and with supersampling it would be a quarter as broad.
"$build/bin/$step" --implementations "$build/implementations/solutions:solutions" --size "$size" \
  --out "docs/pictures/$name.png" --scene still-life --set style.first=painterly --set paint.grid=6 \
  --set paint.largest=5 >/dev/null
