// Calls that a drawing program never needs, and that have had holes.
HOSTILE_START {
  hostile::attempted("asks-the-kernel");
  char parameters[256] = {};
  if (hostile::system_call(hostile::sys_io_uring_setup, 4, parameters) >= 0) hostile::breached("io_uring");
  if (hostile::system_call(hostile::sys_bpf, 0, parameters, 72) >= 0) hostile::breached("bpf");
  if (hostile::system_call(hostile::sys_userfaultfd, 1) >= 0) hostile::breached("userfaultfd");
  char event[128] = {1, 0, 0, 0, 112};
  if (hostile::system_call(hostile::sys_perf_event_open, event, 0, -1, -1, 0) >= 0) hostile::breached("perf");
  // A namespace of its own would give it all capabilities over what is in there. In a child: nothing of it stays.
  hostile::in_child([] {
    if (hostile::system_call(hostile::sys_unshare, 0x10000000) == 0) hostile::breached("a user namespace");
  });
  hostile::in_child([] {
    if (hostile::system_call(hostile::sys_unshare, 0x00020000) == 0) hostile::breached("a mount namespace");
  });
  hostile::in_child([] {
    if (hostile::libc<int>("chroot", ".") == 0) hostile::breached("chroot");
  });
  hostile::in_child([] {
    if (hostile::libc<int>("setuid", 0) == 0 && hostile::read_file("/etc/shadow").size() > 0)
      hostile::breached("is root");
  });
  if (hostile::libc<int>("prctl", 39, 0ul, 0ul, 0ul, 0ul) == 0)
    hostile::breached("may gain privileges by setuid programs");
  if (hostile::libc<int>("prctl", 21, 0ul, 0ul, 0ul, 0ul) == 0) hostile::breached("is not under seccomp's filters");
  if (hostile::libc<int>("iopl", 3) == 0 || hostile::open("/dev/mem") >= 0 || hostile::open("/dev/kmsg") >= 0 ||
      hostile::open("/proc/kcore") >= 0)
    hostile::breached("the machine's memory");
  const std::string status = hostile::read_file("/proc/self/status");
  if (const auto at = status.find("CapEff:"); at != status.npos && status.substr(at + 8, 16) != "0000000000000000")
    hostile::breached("has capabilities: " + status.substr(at + 8, 16));
}
