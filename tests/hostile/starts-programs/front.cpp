// setuid programs, a shell, a compiler, and its own program with a library in front.
extern "C" char** environ;
HOSTILE_START {
  if (std::getenv("HOSTILE_AGAIN")) return;
  hostile::attempted("starts-programs");
  hostile::libc<int>("setenv", "HOSTILE_AGAIN", "1", 1);
  hostile::libc<int>("setenv", "LD_PRELOAD", "/tmp/atelier-hostile.so", 1);
  hostile::libc<int>("setenv", "LD_LIBRARY_PATH", hostile::answers().c_str(), 1);
  const std::string mark = "echo x > " + hostile::canary + "/written-starts-programs; cat " + hostile::secret_file;
  std::vector<std::vector<std::string>> all = {
      {"/bin/sh", "-c", mark},
      {"/usr/bin/su", "-c", mark},
      {"/usr/bin/sudo", "-n", "sh", "-c", mark},
      {"/usr/bin/c++", "-E", "-include", hostile::secret_file, "-xc++", "/dev/null"},
      {"/usr/bin/ld", "--verbose"},
      {"/usr/bin/bwrap", "--dev-bind", "/", "/", "sh", "-c", mark},
      {"/usr/bin/unshare", "-r", "sh", "-c", mark}};
  for (auto& arguments : all)
    hostile::in_child([&] {
      hostile::end_after(3);
      std::vector<char*> pointers;
      for (std::string& argument : arguments) pointers.push_back(argument.data());
      pointers.push_back(nullptr);
      hostile::libc<int>("execv", pointers[0], pointers.data());
    });
}
