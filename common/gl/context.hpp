// OpenGL contexts: a software renderer in memory, a GPU without a display, or a window.
#pragma once

#include <memory>
#include <string>

#include "gl/gl.hpp"

namespace atelier {

enum class ContextKind {
  osmesa,  ///< Mesa's off-screen renderer: the default without a window; removed in Mesa 25.1
  egl,     ///< EGL without a surface: software, or a GPU if there is one
  window,  ///< hidden GLFW window
};

/// A context of OpenGL 3.3 core or newer without a visible window, current on the thread that creates it for its whole
/// lifetime. Do not draw to the default framebuffer; draw into targets.
class HeadlessContext {
 public:
  virtual ~HeadlessContext() = default;
  virtual Gl& gl() = 0;
  virtual ContextKind kind() const = 0;
};

/// Throws Error if the library or the driver is missing, and names the package to install.
std::unique_ptr<HeadlessContext> make_headless_context(ContextKind kind);

/// OSMesa if it is installed. Otherwise EGL, with its software driver if it has one, so that pictures are the same with
/// and without a GPU (sets the variable LIBGL_ALWAYS_SOFTWARE unless it is already set). Otherwise a hidden window.
/// Throws Error with all three reasons if none works.
std::unique_ptr<HeadlessContext> make_headless_context();

/// Content scale of the hidden window whose context is current: 1 on a standard screen, 2 on a high-DPI screen. Throws
/// Error if no window's context is current.
float window_content_scale();

std::string to_string(ContextKind kind);
/// Throws Error naming the three kinds.
ContextKind parse_context_kind(const std::string& text);

}  // namespace atelier
