// Names for what is drawn and for what it is drawn with: shown by --stats, and by tools that look into a frame
// (docs/looking-into-a-frame.md). They go to the driver by KHR_debug; where it has none, only --stats knows the groups.
#pragma once

#include <string_view>

#include "gl/gl.hpp"

namespace atelier {

class Target;

/// A named part of a frame, from here to the end of the scope, left by an exception or not:
///
///   const DebugGroup group(gl, "shadow maps");
///
/// Groups nest. What is drawn meanwhile is counted for each (Gl::groups()). No name is refused; the driver gets it cut
/// to what it allows, and no group where as many are open as it allows. Raises no OpenGL error and never throws. `gl`
/// must outlive it.
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
/// GL_VERTEX_ARRAY. The name is cut to what the driver allows. Does nothing for id 0, for another kind, where there is
/// no such object (all but programs exist from their first binding on), and where the driver has no KHR_debug. Raises
/// no OpenGL error.
void label(Gl& gl, GLenum kind, GLuint id, std::string_view name);

/// Names a target's framebuffer "NAME", and its textures "NAME: colour" and "NAME: depth".
void label(Gl& gl, const Target& target, std::string_view name);

}  // namespace atelier
