#include "gl/debug.hpp"

#include <algorithm>
#include <string>

#include "gl/target.hpp"

namespace atelier {
namespace {

/// The longest prefix of `name` that is shorter than `limit` bytes and ends with a complete UTF-8 character.
std::string_view shorter_than(GLint limit, std::string_view name) {
  std::size_t size = std::size_t(std::max(limit, 1)) - 1;
  if (name.size() <= size) return name;
  const auto inside_character = [&](std::size_t i) { return (static_cast<unsigned char>(name[i]) & 0xC0) == 0x80; };
  while (size > 0 && inside_character(size)) --size;
  return name.substr(0, size);
}

bool is_there(const Gl& gl, GLenum kind, GLuint id) {
  switch (kind) {
    case GL_BUFFER:
      return gl.IsBuffer(id);
    case GL_FRAMEBUFFER:
      return gl.IsFramebuffer(id);
    case GL_PROGRAM:
      return gl.IsProgram(id);
    case GL_RENDERBUFFER:
      return gl.IsRenderbuffer(id);
    case GL_TEXTURE:
      return gl.IsTexture(id);
    case GL_VERTEX_ARRAY:
      return gl.IsVertexArray(id);
    default:
      return false;
  }
}

}  // namespace

DebugGroup::DebugGroup(Gl& gl, std::string_view name) noexcept : gl_(gl) {
  const int open = gl.begin_group(name);
  pushed_ = gl.PushDebugGroup.call && open < gl.debug_limits().group_depth;
  if (!pushed_) return;
  const std::string_view message = shorter_than(gl.debug_limits().message, name);
  gl.PushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, GLsizei(message.size()), message.data());
}

DebugGroup::~DebugGroup() {
  gl_.end_group();
  if (pushed_) gl_.PopDebugGroup();
}

void label(Gl& gl, GLenum kind, GLuint id, std::string_view name) {
  if (!gl.ObjectLabel.call || id == 0 || !is_there(gl, kind, id)) return;
  const std::string_view text = shorter_than(gl.debug_limits().label, name);
  gl.ObjectLabel(kind, id, GLsizei(text.size()), text.data());
}

void label(Gl& gl, const Target& target, std::string_view name) {
  label(gl, GL_FRAMEBUFFER, target.framebuffer(), name);
  label(gl, GL_TEXTURE, target.colour_texture(), std::string(name) + ": colour");
  label(gl, GL_TEXTURE, target.depth_texture(), std::string(name) + ": depth");
}

}  // namespace atelier
