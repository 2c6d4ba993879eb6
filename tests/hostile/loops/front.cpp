// Also ignores every signal that it can; ends after 120 s.
HOSTILE_START {
  hostile::attempted("loops");
  for (int signal = 1; signal < 32; ++signal) hostile::libc<void*>("signal", signal, reinterpret_cast<void*>(1));
}
static void hostile_hook() {
  for (const long begin = hostile::seconds_now(); hostile::seconds_now() < begin + 120;) {
  }
}
