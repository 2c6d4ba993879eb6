draw --scene crossing --set parallax.layers=128 --set parallax.write_depth=true --set parallax.shadow_samples=64
