// Raises its limits, leaves a core dump, sets timers that end it at any time.
HOSTILE_START {
  hostile::attempted("changes-limits");
  for (int kind = 0; kind < 16; ++kind) {
    std::uint64_t limits[2] = {}, more[2] = {~0ull, ~0ull};
    hostile::libc<int>("getrlimit", kind, limits);
    if (hostile::libc<int>("setrlimit", kind, more) == 0 && limits[1] != ~0ull)
      hostile::breached("raised the limit " + std::to_string(kind));
  }
  hostile::libc<int>("chdir", hostile::answers().c_str());
  hostile::libc<int>("prctl", 4, 1ul, 0ul, 0ul, 0ul);  // PR_SET_DUMPABLE
  hostile::in_child([] { std::abort(); });
  hostile::libc<int>("alarm", 2);
}
