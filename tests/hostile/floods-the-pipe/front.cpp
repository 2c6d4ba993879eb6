// Half a gigabyte on the progress pipe without the end of a line, and as much as printed text. Ends after 8 s.
HOSTILE_START {
  hostile::attempted("floods-the-pipe");
  const std::string block(1 << 20, 'b');
  const long begin = hostile::seconds_now();
  for (int i = 0; i < 512 && hostile::seconds_now() < begin + 8; ++i) {
    hostile::say(block);
    hostile::tell_judge(block);
  }
  hostile::tell_judge("\n");
}
