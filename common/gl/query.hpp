// What OpenGL says of its own state, as values instead of through pointers.
#pragma once

#include <initializer_list>
#include <vector>

#include "gl/gl.hpp"

namespace atelier {

/// A state of one whole number: GL_DEPTH_FUNC, GL_VERTEX_ARRAY_BINDING.
GLint integer_of(const Gl& gl, GLenum name);

/// Of the texture that is bound to `target`: GL_TEXTURE_MIN_FILTER and the like, in the order of the names.
std::vector<GLint> texture_parameters(const Gl& gl, GLenum target, std::initializer_list<GLenum> names);

/// Of its largest level: GL_TEXTURE_WIDTH and the like. Of a cube, `target` is a face.
std::vector<GLint> level_parameters(const Gl& gl, GLenum target, std::initializer_list<GLenum> names);

}  // namespace atelier
