static void hang() {
  for (int i = 0; i < 120; ++i) hostile::sleep(1);
}
HOSTILE_START {
  hostile::attempted("hangs-at-exit");
  std::atexit(hang);
}
