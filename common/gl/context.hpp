// Where OpenGL comes from: a software renderer in memory, a GPU without a display, or a window.
#pragma once

#include <memory>
#include <string>

#include "gl/gl.hpp"

namespace atelier {

enum class ContextKind {
  osmesa,  ///< Mesa's off-screen renderer: the default without a window; gone from Mesa 25.1 on
  egl,     ///< EGL without a surface: software, or a GPU where there is one
  window,  ///< GLFW, hidden
};

/// A context of OpenGL 3.3 core or newer without a window, current from its making to its end on the making thread.
/// There is no default framebuffer worth drawing to: draw into targets.
class HeadlessContext {
 public:
  virtual ~HeadlessContext() = default;
  virtual Gl& gl() = 0;
  virtual ContextKind kind() const = 0;
};

/// Throws Error where the library or the driver is missing, saying which package brings it.
std::unique_ptr<HeadlessContext> make_headless_context(ContextKind kind);

/// OSMesa where it is installed; otherwise EGL, by its software driver where it has one, so that the same pictures come
/// out with a GPU and without (the variable LIBGL_ALWAYS_SOFTWARE is set unless it is there); otherwise a hidden
/// window, for systems that have neither. Throws Error with the reason of each where there is none.
std::unique_ptr<HeadlessContext> make_headless_context();

/// Of the hidden window whose context is current: pixels of its screen for a unit of design, 1 on a plain screen and
/// 2 on a fine one. Throws Error where no window's context is current.
float window_content_scale();

std::string to_string(ContextKind kind);
/// Throws Error naming the three kinds.
ContextKind parse_context_kind(const std::string& text);

}  // namespace atelier
