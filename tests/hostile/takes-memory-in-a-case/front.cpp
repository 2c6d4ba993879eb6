static std::vector<std::vector<char>> taken;
HOSTILE_START {
  hostile::attempted("takes-memory-in-a-case");
}
static void hostile_hook() {
  for (std::size_t all = 0; all < std::size_t(3) << 30; all += 64 << 20) taken.emplace_back(64 << 20, '\1');
}
