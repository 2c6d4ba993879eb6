// Kills the test's process, and what shares our group and session.
HOSTILE_START {
  hostile::attempted("kills-others");
  for (const std::string& name : hostile::entries("/proc")) {
    if (name.find_first_not_of("0123456789") != name.npos) continue;
    if (hostile::read_file("/proc/" + name + "/cmdline").find(hostile::canary_process) == std::string::npos) continue;
    if (hostile::libc<int>("kill", std::atoi(name.c_str()), hostile::signal_kill) == 0)
      hostile::breached("killed " + hostile::canary_process);
  }
}
static void hostile_hook() {
  hostile::libc<int>("kill", 0, hostile::signal_kill);  // the own group
}
