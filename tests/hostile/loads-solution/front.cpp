// Loads every library of the solution that it can find, and lets it answer: the loader takes the first definition.
HOSTILE_START {
  hostile::attempted("loads-solution");
  const std::string maps = hostile::read_file("/proc/self/maps", 1 << 22);
  for (std::size_t at = maps.find('/'); at != maps.npos;) {
    const std::size_t end = std::min(maps.find('\n', at), maps.size());
    std::string folder = maps.substr(at, end - at);
    while (folder.size() > 1) {
      folder = folder.substr(0, folder.rfind('/'));
      for (const char* place : {"/implementations/solutions", "/solutions"}) {
        const std::string library = folder + place + "/01-transforms/libstep.so";
        if (!hostile::exists(library)) continue;
        hostile::breached("sees " + library);
        hostile::libc<void*>("dlopen", library.c_str(), 0x102);  // RTLD_NOW | RTLD_GLOBAL
      }
    }
    at = maps.find('/', end);
  }
}
