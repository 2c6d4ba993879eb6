// RAII owners of OpenGL objects: movable, not copyable.
#pragma once

#include <utility>

#include "gl/gl.hpp"

namespace atelier {

/// The object's name (a number) and its context. `Kind` says how it is created and deleted.
template <class Kind>
class GlObject {
 public:
  GlObject() = default;  ///< holds nothing
  explicit GlObject(Gl& gl) : gl_(&gl), id_(Kind::make(gl)) {}
  GlObject(Gl& gl, GLuint adopted) : gl_(&gl), id_(adopted) {}  ///< takes ownership of an existing object
  GlObject(GlObject&& other) noexcept : gl_(other.gl_), id_(std::exchange(other.id_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(gl_, other.gl_);
    std::swap(id_, other.id_);
    return *this;
  }
  ~GlObject() {
    if (id_) Kind::remove(*gl_, id_);
  }
  GLuint id() const { return id_; }
  explicit operator bool() const { return id_ != 0; }

 private:
  Gl* gl_ = nullptr;
  GLuint id_ = 0;
};

#define ATELIER_GL_KIND(Name, Generate, Delete)                  \
  struct Name##Kind {                                            \
    static GLuint make(Gl& gl) {                                 \
      GLuint id = 0;                                             \
      gl.Generate(1, &id);                                       \
      return id;                                                 \
    }                                                            \
    static void remove(Gl& gl, GLuint id) { gl.Delete(1, &id); } \
  };                                                             \
  using Name = GlObject<Name##Kind>;
ATELIER_GL_KIND(GlBuffer, GenBuffers, DeleteBuffers)
ATELIER_GL_KIND(GlVertexArray, GenVertexArrays, DeleteVertexArrays)
ATELIER_GL_KIND(GlTexture, GenTextures, DeleteTextures)
ATELIER_GL_KIND(GlFramebuffer, GenFramebuffers, DeleteFramebuffers)
ATELIER_GL_KIND(GlRenderbuffer, GenRenderbuffers, DeleteRenderbuffers)
#undef ATELIER_GL_KIND

struct GlProgramKind {
  static GLuint make(Gl& gl) { return gl.CreateProgram(); }
  static void remove(Gl& gl, GLuint id) { gl.DeleteProgram(id); }
};
using GlProgram = GlObject<GlProgramKind>;

/// Creating a shader needs its stage, so it is always adopted: GlShader(gl, gl.CreateShader(GL_VERTEX_SHADER)).
struct GlShaderKind {
  static void remove(Gl& gl, GLuint id) { gl.DeleteShader(id); }
};
using GlShader = GlObject<GlShaderKind>;

}  // namespace atelier
