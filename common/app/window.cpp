#include "app/window.hpp"

#include <fmt/core.h>

#include "app/window/module.hpp"
#include "base/error.hpp"
#include "base/module.hpp"

namespace atelier {

int run_window(const StepIdentity& identity, const Implementations& implementations, const CommandLine& line) {
  if (line.context && *line.context != ContextKind::window)
    throw Error(fmt::format("--context {}: a window brings its own OpenGL; add --out FILE.png to draw without one",
                            to_string(*line.context)));
  using Show = int (*)(const WindowRequest&);
  const auto show = reinterpret_cast<Show>(module_symbol("atelier-window", "atelier_show_window"));
  return show({identity, implementations, line, [&] { return load_step(identity, implementations); }});
}

}  // namespace atelier
