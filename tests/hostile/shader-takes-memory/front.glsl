// An array of 16 MB for each of the corners that are computed together.
float hostile_hook() {
  float sum = 0.0;
  float much[4194304];
  for (int i = 0; i < 65000; ++i) much[(i * 64) & 4194303] = float(i);
  for (int i = 0; i < 65000; ++i) sum += much[(i * 128) & 4194303];
  return sum;
}
