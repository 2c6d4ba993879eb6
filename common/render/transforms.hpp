// The functions of step 01 as a table that programs pass to the renderer, since common/ depends on no step.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "gl/gl.hpp"
#include "scene/scene.hpp"

namespace atelier {

/// One node of a hierarchy: its local matrix and its parent.
struct Joint {
  int parent = -1;        ///< index of the parent, -1 for a root; parents may come after their children
  glm::mat4 local{1.0f};  ///< from the node's space to its parent's
};

/// A mesh uploaded to OpenGL: object names (numbers), which the receiver must delete.
struct MeshBuffers {
  GLuint vertex_array = 0;   ///< which buffer feeds which attribute
  GLuint vertex_buffer = 0;  ///< the vertices, interleaved
  GLuint index_buffer = 0;   ///< 0 if the vertices are drawn in order, without indices
  GLsizei count = 0;         ///< number of indices, or of vertices if there are none
};

/// Attribute locations in all shaders of the course.
inline constexpr GLuint attribute_position = 0, attribute_normal = 1, attribute_texcoord = 2, attribute_tangent = 3;

/// The functions of step 01. That step's contract header specifies spaces and errors.
struct TransformFunctions {
  glm::mat4 (*compose)(const glm::vec3& translation, const glm::vec3& axis, float angle,
                       const glm::vec3& scale) = nullptr;
  std::vector<glm::mat4> (*world_matrices)(std::span<const Joint> joints) = nullptr;
  glm::mat4 (*look_at)(const glm::vec3& eye, const glm::vec3& target, const glm::vec3& up) = nullptr;
  glm::mat4 (*perspective)(float fov_y, float aspect, float near, float far) = nullptr;
  glm::mat4 (*perspective_reversed)(float fov_y, float aspect, float near, float far) = nullptr;
  glm::mat4 (*orthographic)(float left, float right, float bottom, float top, float near, float far) = nullptr;
  glm::mat3 (*normal_matrix)(const glm::mat4& model) = nullptr;
  glm::vec3 (*relative_to_eye)(const glm::dvec3& position, const glm::dvec3& eye) = nullptr;
  MeshBuffers (*upload_mesh)(Gl& gl, std::span<const Vertex> vertices,
                             std::span<const std::uint32_t> indices) = nullptr;
  void (*set_wireframe)(Gl& gl, bool on) = nullptr;
  std::string glsl;  ///< the include that defines clip_position, world_position and world_normal
};

}  // namespace atelier
