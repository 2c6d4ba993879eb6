#include "app/window/module.hpp"

#include <fmt/core.h>

#include <cstdlib>

#include "app/window/loop.hpp"
#include "base/error.hpp"

int atelier_show_window(const atelier::WindowRequest& request) {
  using namespace atelier;
  std::optional<CommandLine> again;
  {
    Window window(request, options_from_environment());
    again = window.run();
    const glm::ivec2 place = window.place();
    if (again) setenv("ATELIER_WINDOW_PLACE", fmt::format("{},{}", place.x, place.y).c_str(), 1);
  }  // destroy the window before the program is replaced
  if (again) restart(this_program(), *again);
  return exit_ok;
}
