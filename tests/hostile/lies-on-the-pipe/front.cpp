// "end" before "begin", cases that nobody asked, twice the same, control characters and NUL; then answers in advance.
HOSTILE_START {
  hostile::attempted("lies-on-the-pipe");
  const auto cases = hostile::asked_cases();
  for (const auto& asked : cases) hostile::tell_judge("end " + asked.name + "\n");
  for (const char* line : {"begin ../../etc/passwd\n", "end ../../etc/passwd\n", "begin \n", "end \n", "begin\n",
                           "\n\n", "begin \x1b[2J\n", "end \xff\xfe\n", "passed translation\n", "score 100\n"})
    hostile::tell_judge(line);
  hostile::tell_judge(std::string("begin translation\0\n", 19));
  for (const auto& asked : cases) {
    hostile::write_file(hostile::answers() + "/" + asked.name + ".values", "{\"results\": [[1]], \"passed\": true}");
    for (int twice = 0; twice < 2; ++twice) hostile::tell_judge("begin " + asked.name + "\nend " + asked.name + "\n");
  }
}
