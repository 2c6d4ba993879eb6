// A hundred thousand statements, each of which depends on the last.
#define HOSTILE_10(x) x x x x x x x x x x
float hostile_hook() {
  float sum = 0.0;
  HOSTILE_10(HOSTILE_10(HOSTILE_10(HOSTILE_10(HOSTILE_10(sum = sin(sum + 0.1);)))))
  return sum;
}
