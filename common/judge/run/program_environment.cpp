#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <string>

#include "base/launch.hpp"
#include "judge/run/runner.hpp"

namespace atelier::judge {
bool affects_driver(const std::string& variable) {
  constexpr const char* prefixes[] = {"LP_", "GALLIUM_", "GALLIVM_", "MESA_", "LIBGL_", "LD_", "LC_"};
  return std::any_of(std::begin(prefixes), std::end(prefixes),
                     [&](const char* prefix) { return variable.starts_with(prefix); });
}

std::map<std::string, std::string> program_environment(const RunSettings& settings) {
  std::map<std::string, std::string> environment;
  if (settings.sandbox)
    environment = {{"PATH", "/usr/bin:/bin"}};
  else
    environment = own_environment();
  std::erase_if(environment, [](const auto& variable) { return affects_driver(variable.first); });
  environment["LANG"] = "C";
  environment["LP_NUM_THREADS"] = std::to_string(settings.driver_threads);
  // Without LLVM's optimisation passes llvmpipe compiles shaders in half the time, and draws the same bits.
  environment["GALLIVM_PERF"] = "nopt";
  if (settings.shader_cache.empty() || settings.sandbox)
    environment["MESA_SHADER_CACHE_DISABLE"] = "true";
  else
    environment["MESA_SHADER_CACHE_DIR"] = std::filesystem::absolute(settings.shader_cache).string();
  // Sanitizers exit by default; make them abort, so that their findings count as crashes.
  for (const char* name : {"ASAN_OPTIONS", "UBSAN_OPTIONS"}) environment.try_emplace(name, "abort_on_error=1");
  for (const auto& [name, value] : settings.environment) environment[name] = value;
  return environment;
}

}  // namespace atelier::judge
