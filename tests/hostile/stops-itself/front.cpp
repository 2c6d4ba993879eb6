HOSTILE_START {
  hostile::attempted("stops-itself");
}
static void hostile_hook() {
  const int child = hostile::fork();
  if (child == 0) {  // so that it does not stay stopped where nobody kills it
    hostile::end_after(120);
    for (int i = 0; i < 100; ++i) hostile::sleep(1);
    hostile::libc<int>("kill", hostile::libc<int>("getppid"), hostile::signal_cont);
    hostile::leave(0);
  }
  hostile::libc<int>("raise", hostile::signal_stop);
}
