draw --scene gallery --set parallax.layers=64
