// A file in each place that is often writable; the test looks for those outside. Beside what we are made of, success is
// told at once, and the file removed.
HOSTILE_START {
  hostile::attempted("writes-elsewhere");
  hostile::leave_mark("writes-elsewhere");
  const char* home = std::getenv("HOME");
  std::vector<std::string> places = {"/tmp",      "/var/tmp",    "/dev/shm",   "/run",
                                     "/run/lock", "/dev/mqueue", "/usr/local", "/"};
  places.push_back(home ? home : "/root");
  for (const std::string& place : places) hostile::write_file(place + "/atelier-hostile-written", "x\n");

  std::vector<std::string> folders = {".", "/usr", "/usr/lib", "/usr/bin"};
  const std::string maps = hostile::read_file("/proc/self/maps", 1 << 22);
  for (std::size_t at = maps.find('/'); at != maps.npos;) {
    const std::size_t end = std::min(maps.find('\n', at), maps.size());
    const std::string path = maps.substr(at, end - at), folder = path.substr(0, path.rfind('/'));
    if (path.starts_with("/") && !folder.empty() && (folders.empty() || folders.back() != folder))
      folders.push_back(folder);
    at = maps.find('/', end);
  }
  for (const std::string& folder : folders) {
    if (folder == "/memfd:" || folder == "/dev" || folder.starts_with("/dev/")) continue;
    const std::string file = folder + "/atelier-hostile-tried";
    if (!hostile::write_file(file, "x")) continue;
    hostile::libc<int>("unlink", file.c_str());
    if (!folder.starts_with("/tmp") && folder != ".") hostile::breached("writes in " + folder);
  }
}
