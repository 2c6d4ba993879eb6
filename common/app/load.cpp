#include "app/load.hpp"

#include <dlfcn.h>
#include <fmt/core.h>

#include <algorithm>
#include <memory>

#include "app/thrown.hpp"
#include "base/error.hpp"
#include "base/module.hpp"

namespace atelier {

namespace {

const std::filesystem::path project_root = ATELIER_ROOT, build_root = ATELIER_BUILD;

/// Translates the loader's "FILE: undefined symbol: _ZN..." to a message that names the missing function.
std::string explain_loader(const std::string& words, const std::string& step) {
  const std::string key = "undefined symbol: ";
  const auto at = words.find(key);
  if (at == std::string::npos) return fmt::format("{}: cannot be loaded: {}", step, words);
  const std::string symbol =
      words.substr(at + key.size(), words.find_first_of(" ,;:()\n", at + key.size()) - at - key.size());
  return fmt::format(
      "{}: no step defines the function `{}`, which the contract declares: check its name, its parameters and its "
      "namespace",
      step, demangle(symbol));
}

void open_library(const std::filesystem::path& file, const std::string& step) {
  if (!dlopen(file.c_str(), RTLD_NOW | RTLD_GLOBAL)) throw Error(explain_loader(dlerror(), step));
}

}  // namespace

Implementations default_implementations(const StepIdentity& identity) {
  const auto mine = build_root / "implementations" / "mine", solutions = build_root / "implementations" / "solutions";
  const std::string& step = identity.name;
  const auto& libraries = identity.libraries;
  // Shader files and library must belong together: if the student's C++ is not built yet, do not use their GLSL.
  const bool has_library = std::find(libraries.begin(), libraries.end(), step) != libraries.end();
  const bool built = !has_library || std::filesystem::exists(mine / step / "libstep.so");
  std::vector<Implementations::Root> wanted;
  if (built) wanted = {{mine, step}, {project_root / "steps", step}};
  for (const auto& folder : {solutions, project_root / "solutions", mine, project_root / "steps"})
    wanted.push_back({folder, ""});
  std::erase_if(wanted, [](const auto& root) { return !std::filesystem::is_directory(root.folder); });
  return Implementations(std::move(wanted));
}

Implementations with_given_files(const Implementations& implementations) {
  auto roots = implementations.roots();
  roots.push_back({project_root / "steps", ""});
  return Implementations(std::move(roots));
}

void load_libraries(const StepIdentity& identity, const Implementations& implementations) {
  for (const std::string& step : identity.libraries) {
    const auto library = implementations.find(step + "/libstep.so");
    if (library.empty())
      throw Error(fmt::format("{}: its code is not built yet: run ./atelier check {}", step, step.substr(0, 2)));
    open_library(library, step);
  }
}

std::unique_ptr<StepProgram> load_step(const StepIdentity& identity, const Implementations& implementations) {
  load_libraries(identity, implementations);
  using Make = StepProgram* (*)();
  try {
    const auto make = reinterpret_cast<Make>(module_symbol("program-" + identity.name, "atelier_step_program"));
    return std::unique_ptr<StepProgram>(make());
  } catch (const Error& error) {
    throw Error(explain_loader(error.what(), identity.name));
  }
}

}  // namespace atelier
