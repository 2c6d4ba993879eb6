// Nested so deeply that parsers run out of stack, or of time.
#define HOSTILE_10(a) a a a a a a a a a a
#define HOSTILE_MANY(a) HOSTILE_10(HOSTILE_10(HOSTILE_10(HOSTILE_10(HOSTILE_10(a)))))
static const int hostile_number = HOSTILE_MANY(~-) 1;
