#define HOSTILE_1(x) x x x x x x x x x x
#define HOSTILE_2(x) HOSTILE_1(HOSTILE_1(HOSTILE_1(HOSTILE_1(x))))
#pragma GCC diagnostic error "-Wall"
HOSTILE_2(static int* const hostile_error = "\x1b[31m an error of <script>alert('atelier-hostile')</script>";)
