// Stops, traces and reads the judge: the process whose command line has "grade", wherever it is among our ancestors.
static bool is_judge(const std::string& folder) {
  std::string line = hostile::read_file(folder + "/cmdline");
  for (char& c : line)
    if (c == '\0') c = ' ';
  return line.find("atelier") != line.npos && line.find(" grade ") != line.npos;
}
HOSTILE_START {
  hostile::attempted("attacks-judge");
  for (const std::string& name : hostile::entries("/proc")) {
    if (name.find_first_not_of("0123456789") != name.npos || !is_judge("/proc/" + name)) continue;
    const int judge = std::atoi(name.c_str());
    if (hostile::libc<int>("kill", judge, 0) != 0) continue;
    hostile::breached("may send signals to the judge");
    hostile::libc<int>("kill", judge, hostile::signal_stop);
    hostile::libc<int>("kill", judge, hostile::signal_cont);
    char memory[16] = {};
    struct {
      void* base;
      std::size_t length;
    } here = {memory, sizeof memory}, there = {reinterpret_cast<void*>(0x400000), sizeof memory};
    hostile::system_call(hostile::sys_process_vm_readv, judge, &here, 1, &there, 1, 0);
    if (hostile::open("/proc/" + name + "/mem", 2) >= 0) hostile::breached("opens the judge's memory");
    if (hostile::system_call(hostile::sys_ptrace, 0x4206, judge, 0, 0) == 0) {  // PTRACE_SEIZE
      hostile::breached("traces the judge");
      hostile::system_call(hostile::sys_ptrace, 17, judge, 0, 0);  // PTRACE_DETACH
    }
    const long handle = hostile::system_call(hostile::sys_pidfd_open, judge, 0);
    if (handle >= 0 && hostile::system_call(hostile::sys_pidfd_getfd, handle, 1, 0) >= 0)
      hostile::breached("takes a descriptor of the judge");
    struct {
      std::uint64_t soft, hard;
    } limits = {10'000, 10'000};
    if (hostile::libc<int>("prlimit", judge, 1, static_cast<void*>(nullptr), &limits) == 0)  // RLIMIT_FSIZE, only read
      hostile::breached("may change the judge's limits");
    if (hostile::libc<int>("setpriority", 0, judge, 0) == 0) hostile::breached("may change the judge's priority");
  }
}
