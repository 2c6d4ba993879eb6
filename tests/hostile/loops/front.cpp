// Also ignores every signal that it can; ends after 120 s.
#include <ctime>
HOSTILE_START {
  hostile::attempted("loops");
  for (int signal = 1; signal < 32; ++signal) hostile::libc<void*>("signal", signal, reinterpret_cast<void*>(1));
}
static void hostile_hook() {
  for (const std::time_t begin = std::time(nullptr); std::time(nullptr) < begin + 120;) {
  }
}
