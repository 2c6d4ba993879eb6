// Step 01's functions as the renderer needs them, from a library: tests of the renderer must not depend on any step.
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "render/transforms.hpp"

namespace atelier::test {

/// The include behind TransformFunctions::glsl, and its name.
inline constexpr const char* transforms_name = "00-fake/transforms.glsl";
inline constexpr const char* transforms_glsl = R"(
vec4 clip_position(mat4 projection, mat4 view, mat4 model, vec3 p) {
  return projection * (view * (model * vec4(p, 1.0)));
}
vec3 world_position(mat4 model, vec3 p) { return (model * vec4(p, 1.0)).xyz; }
vec3 world_normal(mat3 normal_matrix, vec3 n) { return normal_matrix * n; }
)";

inline glm::mat4 fake_compose(const glm::vec3& translation, const glm::vec3& axis, float angle,
                              const glm::vec3& scale) {
  const glm::mat4 moved = glm::translate(glm::mat4(1), translation);
  return glm::scale(angle == 0 ? moved : glm::rotate(moved, angle, axis), scale);
}

inline std::vector<glm::mat4> fake_world_matrices(std::span<const Joint> joints) {
  std::vector<glm::mat4> world;
  for (const Joint& joint : joints) {  // in the tests' scenes parents stand first
    world.push_back(joint.parent < 0 ? joint.local : world[std::size_t(joint.parent)] * joint.local);
  }
  return world;
}

/// 1 at the near plane, 0 at the far one.
inline glm::mat4 fake_perspective_reversed(float fov_y, float aspect, float near, float far) {
  glm::mat4 m(0);
  const float f = 1 / std::tan(fov_y / 2);
  m[0][0] = f / aspect;
  m[1][1] = f;
  m[2][2] = near / (far - near);
  m[2][3] = -1;
  m[3][2] = near * far / (far - near);
  return m;
}

inline MeshBuffers fake_upload_mesh(Gl& gl, std::span<const Vertex> vertices, std::span<const std::uint32_t> indices) {
  MeshBuffers made{.count = GLsizei(indices.empty() ? vertices.size() : indices.size())};
  gl.GenVertexArrays(1, &made.vertex_array);
  gl.BindVertexArray(made.vertex_array);
  gl.GenBuffers(1, &made.vertex_buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, made.vertex_buffer);
  gl.BufferData(GL_ARRAY_BUFFER, GLsizeiptr(vertices.size_bytes()), vertices.data(), GL_STATIC_DRAW);
  const auto attribute = [&](GLuint location, GLint size, std::size_t offset) {
    gl.EnableVertexAttribArray(location);
    gl.VertexAttribPointer(location, size, GL_FLOAT, GL_FALSE, sizeof(Vertex), reinterpret_cast<const void*>(offset));
  };
  attribute(attribute_position, 3, offsetof(Vertex, position));
  attribute(attribute_normal, 3, offsetof(Vertex, normal));
  attribute(attribute_texcoord, 2, offsetof(Vertex, texcoord));
  if (!indices.empty()) {
    gl.GenBuffers(1, &made.index_buffer);
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, made.index_buffer);
    gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(indices.size_bytes()), indices.data(), GL_STATIC_DRAW);
  }
  return made;
}

inline TransformFunctions fake_transforms() {
  return {
      .compose = fake_compose,
      .world_matrices = fake_world_matrices,
      .look_at = [](const glm::vec3& eye, const glm::vec3& target,
                    const glm::vec3& up) { return glm::lookAt(eye, target, up); },
      .perspective = [](float fov_y, float aspect, float near,
                        float far) { return glm::perspective(fov_y, aspect, near, far); },
      .perspective_reversed = fake_perspective_reversed,
      .orthographic = [](float left, float right, float bottom, float top, float near,
                         float far) { return glm::ortho(left, right, bottom, top, near, far); },
      .normal_matrix = [](const glm::mat4& model) { return glm::inverseTranspose(glm::mat3(model)); },
      .relative_to_eye = [](const glm::dvec3& position, const glm::dvec3& eye) { return glm::vec3(position - eye); },
      .upload_mesh = fake_upload_mesh,
      .set_wireframe = [](Gl& gl, bool on) { gl.PolygonMode(GL_FRONT_AND_BACK, GLenum(on ? GL_LINE : GL_FILL)); },
      .glsl = transforms_name,
  };
}

}  // namespace atelier::test
