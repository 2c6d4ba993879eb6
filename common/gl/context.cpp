#include "gl/context.hpp"

#include <cstdlib>

#include "base/error.hpp"
#include "gl/context_kinds.hpp"

namespace atelier {
namespace {

thread_local bool thread_has_context = false;

/// Mesa's EGL prefers a GPU unless LIBGL_ALWAYS_SOFTWARE is set.
std::unique_ptr<HeadlessContext> make_software_egl_context() {
  ::setenv("LIBGL_ALWAYS_SOFTWARE", "true", 0);
  return make_egl_context();
}

}  // namespace

CurrentContext::CurrentContext() {
  if (thread_has_context) throw Error("this thread already has an OpenGL context: destroy it before creating another");
  thread_has_context = true;
}

CurrentContext::~CurrentContext() {
  thread_has_context = false;
}

std::unique_ptr<HeadlessContext> make_headless_context(ContextKind kind) {
  switch (kind) {
    case ContextKind::osmesa:
      return make_osmesa_context();
    case ContextKind::egl:
      return make_egl_context();
    case ContextKind::window:
      return make_window_context();
  }
  throw Error("unknown kind of context");
}

std::unique_ptr<HeadlessContext> make_headless_context() {
  std::string reasons;
  for (const auto make : {make_osmesa_context, make_software_egl_context, make_window_context}) {
    try {
      return make();
    } catch (const Error& error) {
      reasons += (reasons.empty() ? "" : "; and ") + std::string(error.what());
    }
  }
  throw Error(reasons);
}

std::string to_string(ContextKind kind) {
  switch (kind) {
    case ContextKind::osmesa:
      return "osmesa";
    case ContextKind::egl:
      return "egl";
    case ContextKind::window:
      return "window";
  }
  return "unknown";
}

ContextKind parse_context_kind(const std::string& text) {
  for (const ContextKind kind : {ContextKind::osmesa, ContextKind::egl, ContextKind::window})
    if (text == to_string(kind)) return kind;
  throw Error("context '" + text + "' is none of osmesa, egl, window");
}

}  // namespace atelier
