// Longer than anybody waits; llvmpipe ends each loop after 65 535 rounds, hence three.
float hostile_hook() {
  float sum = 0.0;
  for (int i = 0; i < 2147483647; ++i)
    for (int j = 0; j < 2147483647; ++j)
      for (int k = 0; k < 2147483647; ++k) sum += fract(float(i ^ j ^ k) * 0.618);
  return sum;
}
