HOSTILE_START {
  hostile::attempted("sleeps-at-start");
  for (int i = 0; i < 120; ++i) hostile::sleep(1);
}
