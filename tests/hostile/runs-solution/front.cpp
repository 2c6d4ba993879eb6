// Executes itself again, with the search path of the solution, which the own program's place leads to.
static std::string build_folder() {
  char path[4096] = {};
  if (hostile::libc<long>("readlink", "/proc/self/exe", static_cast<char*>(path), 4095ul) <= 0) return "";
  std::string folder = path;  // BUILD/bin/NN-name
  for (int level = 0; level < 2; ++level) folder = folder.substr(0, folder.rfind('/'));
  return folder;
}

HOSTILE_START {
  if (std::getenv("HOSTILE_AGAIN")) return;
  hostile::attempted("runs-solution");
  const std::string build = build_folder();
  std::string roots;
  for (const std::string& folder : {build + "/implementations/solutions", build + "/../../solutions",
                                    build + "/../solutions", std::string("/solutions")})
    if (hostile::exists(folder)) {
      roots += folder + ":";
      if (!hostile::entries(folder).empty()) hostile::breached("looks into " + folder);
    }
  if (roots.empty()) return;
  std::vector<std::string> arguments = hostile::command_line();
  for (std::size_t i = 0; i + 1 < arguments.size(); ++i)
    if (arguments[i] == "--implementations") arguments[i + 1] = roots + arguments[i + 1];
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  hostile::libc<int>("setenv", "HOSTILE_AGAIN", "1", 1);
  hostile::libc<int>("execv", "/proc/self/exe", pointers.data());
}
