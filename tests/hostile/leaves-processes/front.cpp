// Grandchildren in sessions of their own, which no longer die with their parent, with a name that the test looks for.
HOSTILE_START {
  hostile::attempted("leaves-processes");
  hostile::libc<int>("prctl", 1, 0ul, 0ul, 0ul, 0ul);  // PR_SET_PDEATHSIG: none
  for (int i = 0; i < 8; ++i) {
    const int child = hostile::fork();
    if (child != 0) continue;
    hostile::libc<int>("setsid");
    if (hostile::fork() != 0) hostile::leave(0);
    hostile::libc<int>("setsid");
    hostile::libc<int>("prctl", 15, "hostile-left", 0ul, 0ul, 0ul);  // PR_SET_NAME
    hostile::libc<int>("prctl", 1, 0ul, 0ul, 0ul, 0ul);
    for (int file = 0; file < 64; ++file) hostile::close(file);
    for (const int signal : {1, 2, 3, 13, 15}) hostile::libc<void*>("signal", signal, reinterpret_cast<void*>(1));
    hostile::end_after(120);
    hostile::leave_mark("leaves-processes");
    for (int second = 0; second < 120; ++second) hostile::sleep(1);
    hostile::leave(0);
  }
}
