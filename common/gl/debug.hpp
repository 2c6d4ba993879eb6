// Names for parts of a frame and for OpenGL objects. --stats and frame debuggers show them
// (docs/looking-into-a-frame.md). They are passed to the driver with KHR_debug; without KHR_debug, only --stats shows
// the groups.
#pragma once

#include <string_view>

#include "gl/gl.hpp"

namespace atelier {

class Target;

/// A named part of a frame, from here to the end of the scope, also if an exception leaves it:
///
///   const DebugGroup group(gl, "shadow maps");
///
/// Groups nest; each counts everything that is drawn inside it (Gl::groups()). Any name is allowed. For the driver,
/// names are cut to its limit, and groups nested deeper than its limit are left out. Raises no OpenGL error and never
/// throws. `gl` must outlive it.
class [[nodiscard]] DebugGroup {
 public:
  DebugGroup(Gl& gl, std::string_view name) noexcept;
  ~DebugGroup();
  DebugGroup(const DebugGroup&) = delete;
  DebugGroup& operator=(const DebugGroup&) = delete;

 private:
  Gl& gl_;
  bool pushed_;
};

/// Names an object for tools; `kind` is GL_BUFFER, GL_FRAMEBUFFER, GL_PROGRAM, GL_RENDERBUFFER, GL_TEXTURE or
/// GL_VERTEX_ARRAY. The name is cut to the driver's limit. Does nothing for id 0, for another kind, if there is no such
/// object (all but programs exist only after their first binding), and without KHR_debug. Raises no OpenGL error.
void label(Gl& gl, GLenum kind, GLuint id, std::string_view name);

/// Names a target's framebuffer "NAME", and its textures "NAME: colour" and "NAME: depth".
void label(Gl& gl, const Target& target, std::string_view name);

}  // namespace atelier
