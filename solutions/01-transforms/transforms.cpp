// 01-transforms: matrices, the camera, normals and vertex buffers. The contract is transforms.hpp.
#include "transforms.hpp"

namespace atelier::transforms {

// ---- Core 1: matrices that move, turn and stretch

glm::mat4 translation(const glm::vec3& offset) {
  // >>> student: the identity with `offset` as its fourth column
  glm::mat4 m(1.0f);
  m[3] = glm::vec4(offset, 1.0f);
  return m;
  // --- skeleton
  // | return glm::mat4(1.0f);
  // <<< student
}

glm::mat4 rotation(const glm::vec3& axis, float angle) {
  // >>> student: Rodrigues' formula, column by column
  const float length = glm::length(axis);
  if (length == 0.0f) return glm::mat4(1.0f);
  const glm::vec3 a = axis / length;
  const float c = std::cos(angle), s = std::sin(angle);
  const glm::vec3 b = (1.0f - c) * a;
  return glm::mat4(b.x * a.x + c, b.x * a.y + s * a.z, b.x * a.z - s * a.y, 0.0f,
                   b.y * a.x - s * a.z, b.y * a.y + c, b.y * a.z + s * a.x, 0.0f,
                   b.z * a.x + s * a.y, b.z * a.y - s * a.x, b.z * a.z + c, 0.0f,
                   0.0f, 0.0f, 0.0f, 1.0f);
  // --- skeleton
  // | return glm::mat4(1.0f);
  // <<< student
}

glm::mat4 scaling(const glm::vec3& factors) {
  // >>> student: the factors along the diagonal
  return glm::mat4(factors.x, 0.0f, 0.0f, 0.0f,
                   0.0f, factors.y, 0.0f, 0.0f,
                   0.0f, 0.0f, factors.z, 0.0f,
                   0.0f, 0.0f, 0.0f, 1.0f);
  // --- skeleton
  // | return glm::mat4(1.0f);
  // <<< student
}

glm::mat4 compose(const glm::vec3& offset, const glm::vec3& axis, float angle, const glm::vec3& factors) {
  // >>> student: scale first, then rotate, then translate; which matrix stands on the right?
  return translation(offset) * rotation(axis, angle) * scaling(factors);
  // --- skeleton
  // | return glm::mat4(1.0f);
  // <<< student
}

std::vector<glm::mat4> world_matrices(std::span<const Joint> joints) {
  // >>> student: walk from each joint up to the first ancestor that is done, then come back down
  const int count = int(joints.size());
  std::vector<glm::mat4> world(joints.size());
  std::vector<bool> done(joints.size(), false);
  std::vector<int> chain;
  for (int i = 0; i < count; ++i) {
    chain.clear();
    for (int j = i; j != -1 && !done[j]; j = joints[j].parent) {
      if (joints[j].parent < -1 || joints[j].parent >= count)
        throw std::invalid_argument("joint " + std::to_string(j) + ": parent " + std::to_string(joints[j].parent));
      if (int(chain.size()) == count) throw std::invalid_argument("joint " + std::to_string(i) + ": cycle of parents");
      chain.push_back(j);
    }
    for (; !chain.empty(); chain.pop_back()) {
      const Joint& joint = joints[chain.back()];
      world[chain.back()] = joint.parent == -1 ? joint.local : world[joint.parent] * joint.local;
      done[chain.back()] = true;
    }
  }
  return world;
  // --- skeleton
  // | std::vector<glm::mat4> world;
  // | for (const Joint& joint : joints) world.push_back(joint.local);
  // | return world;
  // <<< student
}

// ---- Core 2: the camera

glm::mat4 look_at(const glm::vec3& eye, const glm::vec3& target, const glm::vec3& up) {
  // >>> student: the camera's three axes as rows, then the eye taken to the origin
  const glm::vec3 difference = eye - target;
  const glm::vec3 back = difference == glm::vec3(0.0f) ? glm::vec3(0, 0, 1) : glm::normalize(difference);
  glm::vec3 right = glm::cross(up, back);
  if (glm::length(right) <= 1e-6f * glm::length(up)) {
    const glm::vec3 size = glm::abs(back);
    const glm::vec3 stand_in = size.x <= size.y && size.x <= size.z ? glm::vec3(1, 0, 0)
                               : size.y <= size.z                   ? glm::vec3(0, 1, 0)
                                                                    : glm::vec3(0, 0, 1);
    right = glm::cross(stand_in, back);
  }
  right = glm::normalize(right);
  const glm::vec3 above = glm::cross(back, right);
  const glm::mat4 turn(right.x, above.x, back.x, 0.0f,
                       right.y, above.y, back.y, 0.0f,
                       right.z, above.z, back.z, 0.0f,
                       0.0f, 0.0f, 0.0f, 1.0f);
  return turn * translation(-eye);
  // --- skeleton
  // | return translation(-eye);
  // <<< student
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
  // >>> student: refuse what cannot be (check_frustum), then w = -z, and depth from -1 at near to +1 at far
  check_frustum(fov_y, aspect, near, far);
  const float f = 1.0f / std::tan(fov_y / 2.0f);
  return glm::mat4(f / aspect, 0.0f, 0.0f, 0.0f,
                   0.0f, f, 0.0f, 0.0f,
                   0.0f, 0.0f, (near + far) / (near - far), -1.0f,
                   0.0f, 0.0f, 2.0f * near * far / (near - far), 0.0f);
  // --- skeleton
  // | return glm::mat4(1.0f);
  // <<< student
}

glm::mat4 orthographic(float left, float right, float bottom, float top, float near, float far) {
  // >>> student: move the box's centre to the origin, scale its sides to 2; view space looks along -z
  if (left == right || bottom == top || near == far) throw std::invalid_argument("opposite sides of the box are equal");
  return glm::mat4(2.0f / (right - left), 0.0f, 0.0f, 0.0f,
                   0.0f, 2.0f / (top - bottom), 0.0f, 0.0f,
                   0.0f, 0.0f, -2.0f / (far - near), 0.0f,
                   -(right + left) / (right - left), -(top + bottom) / (top - bottom), -(far + near) / (far - near), 1.0f);
  // --- skeleton
  // | return glm::mat4(1.0f);
  // <<< student
}

// ---- Core 3: normals

glm::mat3 normal_matrix(const glm::mat4& model) {
  // >>> student: the cofactors are cross products of columns; mind the sign of the determinant and overflow
  const glm::mat3 m(model);
  const auto largest = [](const glm::vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); };
  const glm::vec3 sizes(largest(m[0]), largest(m[1]), largest(m[2]));
  glm::mat3 scaled = m, each = m;  // by one number, which keeps directions; each column by its own, for the sign
  for (int column = 0; column < 3; ++column)
    if (sizes[column] > 0.0f) {
      scaled[column] = m[column] / largest(sizes);
      each[column] = m[column] / sizes[column];
    }
  const glm::mat3 cofactor(glm::cross(scaled[1], scaled[2]), glm::cross(scaled[2], scaled[0]), glm::cross(scaled[0], scaled[1]));
  return glm::dot(each[0], glm::cross(each[1], each[2])) < 0.0f ? -cofactor : cofactor;
  // --- skeleton
  // | return glm::mat3(1.0f);
  // <<< student
}

// ---- Core 4: vertex buffers

MeshBuffers upload_triangle(Gl& gl, std::span<const glm::vec3, 3> positions) {
  MeshBuffers made;
  // >>> student: make and bind a vertex array, make and fill a buffer, describe and enable attribute_position
  gl.GenVertexArrays(1, &made.vertex_array);
  gl.BindVertexArray(made.vertex_array);
  gl.GenBuffers(1, &made.vertex_buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, made.vertex_buffer);
  gl.BufferData(GL_ARRAY_BUFFER, GLsizeiptr(positions.size_bytes()), positions.data(), GL_STATIC_DRAW);
  gl.VertexAttribPointer(attribute_position, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  gl.EnableVertexAttribArray(attribute_position);
  gl.BindVertexArray(0);
  made.count = 3;
  // --- skeleton
  // <<< student
  return made;
}

MeshBuffers upload_mesh(Gl& gl, std::span<const Vertex> vertices, std::span<const std::uint32_t> indices) {
  MeshBuffers made;
  // >>> student: as for the triangle, with three attributes a stride of sizeof(Vertex) apart, and an index buffer
  gl.GenVertexArrays(1, &made.vertex_array);
  gl.BindVertexArray(made.vertex_array);
  gl.GenBuffers(1, &made.vertex_buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, made.vertex_buffer);
  gl.BufferData(GL_ARRAY_BUFFER, GLsizeiptr(vertices.size_bytes()), vertices.data(), GL_STATIC_DRAW);
  const auto feed = [&](GLuint attribute, GLint components, std::size_t offset) {
    gl.VertexAttribPointer(attribute, components, GL_FLOAT, GL_FALSE, sizeof(Vertex), reinterpret_cast<const void*>(offset));
    gl.EnableVertexAttribArray(attribute);
  };
  feed(attribute_position, 3, offsetof(Vertex, position));
  feed(attribute_normal, 3, offsetof(Vertex, normal));
  feed(attribute_texcoord, 2, offsetof(Vertex, texcoord));
  gl.GenBuffers(1, &made.index_buffer);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, made.index_buffer);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(indices.size_bytes()), indices.data(), GL_STATIC_DRAW);
  gl.BindVertexArray(0);  // before any other index buffer is bound: the vertex array remembers the last one
  made.count = GLsizei(indices.size());
  // --- skeleton
  // <<< student
  return made;
}

// ---- Further: a hall, wireframes, and where a pixel lies

Mesh cylinder_wall(float radius, float height, int segments) {
  Mesh wall;
  // >>> student: refuse what cannot be; then two vertices for each angle 0 .. segments, two triangles for each piece between
  if (!(radius > 0.0f && height > 0.0f && segments >= 3))
    throw std::invalid_argument("cylinder_wall: radius and height must be above 0, segments at least 3");
  for (int i = 0; i <= segments; ++i) {
    const float phi = 6.28318531f * float(i % segments) / float(segments);  // the last pair lies exactly on the first
    const glm::vec3 outward(std::cos(phi), 0.0f, std::sin(phi));
    const float u = float(i) / float(segments);
    wall.vertices.push_back({radius * outward, -outward, {u, 0.0f}});
    wall.vertices.push_back({radius * outward + glm::vec3(0, height, 0), -outward, {u, 1.0f}});
  }
  for (std::uint32_t i = 0; i < std::uint32_t(segments); ++i) {
    const std::uint32_t lower_left = 2 * i, upper_left = lower_left + 1, lower_right = lower_left + 2, upper_right = lower_left + 3;
    for (const std::uint32_t corner : {lower_left, lower_right, upper_right, lower_left, upper_right, upper_left})
      wall.indices.push_back(corner);
  }
  // --- skeleton
  // <<< student
  return wall;
}

Mesh rectangle(const glm::vec3& centre, const glm::vec3& half_u, const glm::vec3& half_v) {
  Mesh flat;
  // >>> student: four vertices, two triangles
  const glm::vec3 normal(glm::normalize(glm::cross(glm::dvec3(half_u), glm::dvec3(half_v))));
  flat.vertices = {{centre - half_u - half_v, normal, {0, 0}},
                   {centre + half_u - half_v, normal, {1, 0}},
                   {centre + half_u + half_v, normal, {1, 1}},
                   {centre - half_u + half_v, normal, {0, 1}}};
  flat.indices = {0, 1, 2, 0, 2, 3};
  // --- skeleton
  // <<< student
  return flat;
}

void set_wireframe(Gl& gl, bool on) {
  // >>> student: glPolygonMode
  gl.PolygonMode(GL_FRONT_AND_BACK, GLenum(on ? GL_LINE : GL_FILL));
  // --- skeleton
  // <<< student
}

glm::vec3 window_position(const glm::vec4& clip, const glm::vec4& viewport) {
  // >>> student: divide by w, then stretch -1..1 over the viewport
  const glm::vec3 device = glm::vec3(clip) / clip.w;
  return {viewport.x + (device.x + 1.0f) / 2.0f * viewport.z,
          viewport.y + (device.y + 1.0f) / 2.0f * viewport.w,
          (device.z + 1.0f) / 2.0f};
  // --- skeleton
  // | return glm::vec3(clip);
  // <<< student
}

// ---- Challenge: far and wide

glm::mat4 perspective_reversed(float fov_y, float aspect, float near, float far) {
  // >>> student: solve depth = (A z + B) / -z for depth 1 at -near and 0 at -far; an infinite far must not give NaN
  check_frustum(fov_y, aspect, near, far);
  const float f = 1.0f / std::tan(fov_y / 2.0f);
  const float ratio = near / far;  // 0 for an infinite far
  return glm::mat4(f / aspect, 0.0f, 0.0f, 0.0f,
                   0.0f, f, 0.0f, 0.0f,
                   0.0f, 0.0f, ratio / (1.0f - ratio), -1.0f,
                   0.0f, 0.0f, near / (1.0f - ratio), 0.0f);
  // --- skeleton
  // | check_frustum(fov_y, aspect, near, far);
  // | return perspective(fov_y, aspect, near, far);
  // <<< student
}

glm::vec3 relative_to_eye(const glm::dvec3& position, const glm::dvec3& eye) {
  // >>> student: subtract in double precision, then round
  return glm::vec3(position - eye);
  // --- skeleton
  // | return glm::vec3(position) - glm::vec3(eye);
  // <<< student
}

}  // namespace atelier::transforms
