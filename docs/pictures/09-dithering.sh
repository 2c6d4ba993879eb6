# One sample a pixel: with supersampling the dots would be averaged into greys.
"$build/bin/$step" --implementations "$build/implementations/solutions:solutions" --size "$size" \
  --out "docs/pictures/$name.png" --scene deck --set dither.method=bayer --set dither.grey=on \
  --set dither.held=sphere --set dither.lines=white >/dev/null
