static std::vector<std::vector<char>> taken;
HOSTILE_START {
  hostile::attempted("takes-memory-in-a-case");
}
static void hostile_hook() {
  hostile::write_file("/proc/self/oom_score_adj", "1000");
  while (taken.size() < 48) taken.emplace_back(64 << 20, '\1');
}
