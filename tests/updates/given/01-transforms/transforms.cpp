// 01-transforms: matrices, the camera, normals and vertex buffers. The contract is transforms.hpp.
#include "transforms.hpp"

namespace atelier::transforms {

// ---- Core 1: matrices that move, turn and stretch

glm::mat4 translation(const glm::vec3& offset) {
  // TODO(01-transforms): the identity with `offset` as its fourth column
  return glm::mat4(1.0f);
}

glm::mat4 rotation(const glm::vec3& axis, float angle) {
  // TODO(01-transforms): Rodrigues' formula, column by column
  return glm::mat4(1.0f);
}

glm::mat4 scaling(const glm::vec3& factors) {
  // TODO(01-transforms): the factors along the diagonal
  return glm::mat4(1.0f);
}

glm::mat4 compose(const glm::vec3& offset, const glm::vec3& axis, float angle, const glm::vec3& factors) {
  // TODO(01-transforms): scale first, then rotate, then translate; which matrix stands on the right?
  return glm::mat4(1.0f);
}

std::vector<glm::mat4> world_matrices(std::span<const Joint> joints) {
  // TODO(01-transforms): walk from each joint up to the first ancestor that is done, then come back down
  std::vector<glm::mat4> world;
  for (const Joint& joint : joints) world.push_back(joint.local);
  return world;
}

// ---- Core 2: the camera

glm::mat4 look_at(const glm::vec3& eye, const glm::vec3& target, const glm::vec3& up) {
  // TODO(01-transforms): the camera's three axes as rows, then the eye taken to the origin
  return translation(-eye);
}

namespace {

constexpr float widest_angle = 3.12413936f;  // 179 degrees

void check_frustum(float fov_y, float aspect, float near, float far) {
  if (!(fov_y > 0.0f && fov_y <= widest_angle)) throw std::invalid_argument("fov_y must be above 0, at most 179 degrees");
  if (!(aspect > 0.0f)) throw std::invalid_argument("aspect must be above 0");
  if (!(near > 0.0f && near < far)) throw std::invalid_argument("0 < near < far must hold");
}

}  // namespace

glm::mat4 perspective(float fov_y, float aspect, float near, float far) {
  // TODO(01-transforms): refuse what cannot be (check_frustum), then w = -z, and depth from -1 at near to +1 at far
  return glm::mat4(1.0f);
}

glm::mat4 orthographic(float left, float right, float bottom, float top, float near, float far) {
  // TODO(01-transforms): move the box's centre to the origin, scale its sides to 2; view space looks along -z
  return glm::mat4(1.0f);
}

// ---- Core 3: normals

glm::mat3 normal_matrix(const glm::mat4& model) {
  // TODO(01-transforms): the cofactors are cross products of columns; mind the sign of the determinant and overflow
  return glm::mat3(1.0f);
}

// ---- Core 4: vertex buffers

MeshBuffers upload_triangle(Gl& gl, std::span<const glm::vec3, 3> positions) {
  MeshBuffers made;
  // TODO(01-transforms): make and bind a vertex array, make and fill a buffer, describe and enable attribute_position
  return made;
}

MeshBuffers upload_mesh(Gl& gl, std::span<const Vertex> vertices, std::span<const std::uint32_t> indices) {
  MeshBuffers made;
  // TODO(01-transforms): as for the triangle, with three attributes a stride of sizeof(Vertex) apart, and an index buffer
  return made;
}

// ---- Further: a hall, wireframes, and where a pixel lies

Mesh cylinder_wall(float radius, float height, int segments) {
  Mesh wall;
  // TODO(01-transforms): refuse what cannot be; then two vertices for each angle 0 .. segments, two triangles for each piece between
  return wall;
}

Mesh rectangle(const glm::vec3& centre, const glm::vec3& half_u, const glm::vec3& half_v) {
  Mesh flat;
  // TODO(01-transforms): four vertices, two triangles
  return flat;
}

void set_wireframe(Gl& gl, bool on) {
  // TODO(01-transforms): glPolygonMode
}

glm::vec3 window_position(const glm::vec4& clip, const glm::vec4& viewport) {
  // TODO(01-transforms): divide by w, then stretch -1..1 over the viewport
  return glm::vec3(clip);
}

// ---- Challenge: far and wide

glm::mat4 perspective_reversed(float fov_y, float aspect, float near, float far) {
  // TODO(01-transforms): solve depth = (A z + B) / -z for depth 1 at -near and 0 at -far; an infinite far must not give NaN
  check_frustum(fov_y, aspect, near, far);
  return perspective(fov_y, aspect, near, far);
}

glm::vec3 relative_to_eye(const glm::dvec3& position, const glm::dvec3& eye) {
  // TODO(01-transforms): subtract in double precision, then round
  return glm::vec3(position) - glm::vec3(eye);
}

}  // namespace atelier::transforms
