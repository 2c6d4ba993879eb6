// At most 1000 processes and 500 threads; all end after 20 s.
static void* wait_here(void*) {
  for (int i = 0; i < 20; ++i) hostile::sleep(1);
  return nullptr;
}
HOSTILE_START {
  hostile::attempted("forks-without-end");
  int made = 0;
  for (int i = 0; i < 1000; ++i) {
    const int child = hostile::fork();
    if (child == 0) {
      hostile::end_after(20);
      hostile::libc<int>("prctl", 15, "hostile-left", 0ul, 0ul, 0ul);
      if (i % 2) hostile::libc<int>("setsid");
      wait_here(nullptr);
      hostile::leave(0);
    }
    made += child > 0;
  }
  for (int i = 0; i < 500; ++i) {
    unsigned long thread = 0;
    hostile::libc<int>("pthread_create", &thread, static_cast<void*>(nullptr), &wait_here, static_cast<void*>(nullptr));
  }
  if (made == 1000) hostile::breached("1000 processes");
}
