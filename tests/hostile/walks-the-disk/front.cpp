// Looks through all folders for what a judge must not show: references, hints, known mistakes, solutions, results,
// other submissions. Stops after 6 s, so that the cases still begin in time.

static void look_at(const std::string& path, const std::string& name) {
  const auto is_in = [&](const char* part) { return path.find(part) != path.npos; };
  for (const char* of_judge : {"hints.json", "mistakes.json", "baseline.json", "ratios.json", "equivalent.json",
                               "gradebook.csv", "record.json", "class.html", "hostile.json"})
    if (name == of_judge) hostile::breached("sees " + path);
  if (is_in("/tests/cases/") || name.ends_with(".values.json") || (is_in("/references/") && name.ends_with(".exr")))
    hostile::breached("sees a reference: " + path);
  if (is_in("/solutions/")) hostile::breached("sees the solution: " + path);
  if (name.ends_with(".cpp") && hostile::read_file(path).find(hostile::honest_mark) != std::string::npos)
    hostile::breached("reads another submission, " + hostile::honest_mark + ": " + path);
  if (path == hostile::secret_file) hostile::breached_if_any("read", hostile::read_file(path));
}

HOSTILE_START {
  hostile::attempted("walks-the-disk");
  const long begin = hostile::seconds_now();
  std::vector<std::string> folders = {"/"};
  for (std::size_t at = 0; at < folders.size() && hostile::seconds_now() < begin + 6 && hostile::reached().size() < 4000;
       ++at) {
    const std::string folder = folders[at];
    for (const std::string& name : hostile::entries(folder)) {
      const std::string path = (folder == "/" ? "" : folder) + "/" + name;
      if (path == "/proc" || path == "/sys" || path == "/dev" || path == "/usr/share" || path == "/usr/lib") continue;
      char target[2];
      if (hostile::libc<long>("readlink", path.c_str(), static_cast<char*>(target), 1ul) >= 0) continue;
      const int opened = hostile::open(path, hostile::read_only | hostile::folder_only);
      if (opened >= 0) folders.push_back(path);
      hostile::close(opened);
      look_at(path, name);
    }
  }
}
