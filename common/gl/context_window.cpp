// A hidden window's context. GLFW is in its own module, so that headless programs neither load nor need it.
#include "base/module.hpp"
#include "gl/context_kinds.hpp"

namespace atelier {

std::unique_ptr<HeadlessContext> make_window_context() {
  // Made by window_module.cpp; owned by the caller.
  using Make = HeadlessContext* (*)();
  const auto make = reinterpret_cast<Make>(module_symbol("atelier-window-context", "atelier_make_window_context"));
  return std::unique_ptr<HeadlessContext>(make());
}

float window_content_scale() {
  const auto scale =
      reinterpret_cast<float (*)()>(module_symbol("atelier-window-context", "atelier_window_content_scale"));
  return scale();
}

}  // namespace atelier
