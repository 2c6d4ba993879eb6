// OpenGL state queries that return values instead of writing through pointers.
#pragma once

#include <initializer_list>
#include <vector>

#include "gl/gl.hpp"

namespace atelier {

/// A single integer state: GL_DEPTH_FUNC, GL_VERTEX_ARRAY_BINDING.
GLint integer_of(const Gl& gl, GLenum name);

/// Parameters of the texture bound to `target`, such as GL_TEXTURE_MIN_FILTER, in the order of the names.
std::vector<GLint> texture_parameters(const Gl& gl, GLenum target, std::initializer_list<GLenum> names);

/// Parameters of its level 0, such as GL_TEXTURE_WIDTH. For a cube map, `target` is a face.
std::vector<GLint> level_parameters(const Gl& gl, GLenum target, std::initializer_list<GLenum> names);

}  // namespace atelier
