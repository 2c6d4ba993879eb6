#include "base/module.hpp"

#include <dlfcn.h>
#include <fmt/core.h>

#include <filesystem>
#include <map>
#include <mutex>

#include "base/error.hpp"

namespace atelier {
namespace {

/// The folder of the library that contains this code.
std::filesystem::path library_folder() {
  static const char here = 0;
  Dl_info info{};
  if (dladdr(&here, &info) == 0 || info.dli_fname == nullptr) return std::filesystem::current_path();
  std::error_code ignored;
  const auto file = std::filesystem::weakly_canonical(info.dli_fname, ignored);
  return (file.empty() ? std::filesystem::path(info.dli_fname) : file).parent_path();
}

void* open_module(const std::string& name) {
  const auto file = library_folder() / fmt::format("lib{}.so", name);  // CMake's MODULE suffix, on macOS too
  // RTLD_NOW: a missing symbol is reported here, not by an abort in a later call.
  if (void* handle = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL)) return handle;
  const char* reason = dlerror();
  throw Error(fmt::format("module '{}' cannot be loaded from {}: {}; rebuild the project", name, file.string(),
                          reason ? reason : "unknown reason"));
}

}  // namespace

void* module_symbol(const std::string& name, const char* symbol) {
  // Modules are never unloaded: their libraries register exit handlers, whose code must stay mapped.
  static std::map<std::string, void*> handles;
  static std::mutex mutex;
  const std::lock_guard lock(mutex);

  auto found = handles.find(name);
  if (found == handles.end()) found = handles.emplace(name, open_module(name)).first;
  if (void* address = dlsym(found->second, symbol)) return address;
  throw Error(fmt::format("module '{}' in {} has no symbol '{}'; rebuild the project", name, library_folder().string(),
                          symbol));
}

}  // namespace atelier
