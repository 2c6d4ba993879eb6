draw --scene lanterns --set bloom.strength=0.5 --set bloom.sigma=20 --set tone.curve=filmic --set tone.exposure=0.5
