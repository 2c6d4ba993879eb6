// Touches memory until there is no more, at most 6 GB, in a child, so that a limit costs us nothing.
HOSTILE_START {
  hostile::attempted("takes-memory");
  hostile::in_child([] {
    // Where nothing stops it, the kernel ends this process before all others.
    hostile::write_file("/proc/self/oom_score_adj", "1000");
    constexpr std::size_t step = 64 << 20, most = std::size_t(6) << 30;
    std::size_t taken = 0;
    for (; taken < most; taken += step) {
      void* block = hostile::libc<void*>("mmap", static_cast<void*>(nullptr), step, 3, 0x22, -1, 0l);
      if (!block || block == reinterpret_cast<void*>(-1)) break;
      for (std::size_t at = 0; at < step; at += 4096) static_cast<volatile char*>(block)[at] = 1;
    }
    if (taken >= most) hostile::breached("6 GB of memory");
  });
}
