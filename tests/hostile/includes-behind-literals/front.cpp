// A reader of text that loses count of quotes takes the directive for a part of a string.
static const char hostile_quote = '"', hostile_other[] = R"x(")x" "'";
static const int hostile_digits = 1'000'000;
/* " */ #include "/tmp/atelier-canary/secret.txt"
static const char hostile_last = '"';
