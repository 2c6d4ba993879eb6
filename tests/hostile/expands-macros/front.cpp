// 10^8 words: 600 MB after the preprocessor.
#define HOSTILE_1(x) x x x x x x x x x x
#define HOSTILE_2(x) HOSTILE_1(HOSTILE_1(HOSTILE_1(HOSTILE_1(x))))
HOSTILE_2(HOSTILE_2(float;))
