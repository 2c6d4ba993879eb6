HOSTILE_START {
  hostile::attempted("reads-environment");
  for (char** entry = hostile::start_environment; entry && *entry; ++entry)
    if (std::string(*entry).starts_with("ATELIER_CANARY")) hostile::breached(std::string("own environment: ") + *entry);
  const std::string own = "/proc/" + std::to_string(hostile::libc<int>("getpid")) + "/";
  for (const std::string& process : hostile::entries("/proc")) {
    const std::string folder = "/proc/" + process + "/";
    if (process.find_first_not_of("0123456789") != process.npos || folder == own) continue;
    std::string environment = hostile::read_file(folder + "environ");
    if (const auto at = environment.find("ATELIER_CANARY"); at != environment.npos)
      hostile::breached(folder + "environ: " + environment.substr(at, 100).c_str());
  }
}
