// All descriptors that there are, then all bytes of pipes.
HOSTILE_START {
  hostile::attempted("takes-descriptors");
  int made = 0;
  for (int pipe[2]; made < 20'000 && hostile::libc<int>("pipe", pipe) == 0; ++made)
    if (made % 2) hostile::libc<int>("fcntl", pipe[1], 1031, 1 << 20);  // F_SETPIPE_SZ
  for (int file = 4; file < 64'000; ++file) hostile::close(file);
}
