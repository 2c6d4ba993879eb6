// 04-point-shadows: the cube map, and what a point light sees all around. The contract is point_shadows.hpp.
#include "04-point-shadows/point_shadows.hpp"

namespace atelier::point_shadows {

// ---- Core 1: the cube and the pass that draws it

CubeMap make_cube_map(Gl& gl, int resolution, GLenum internal_format, bool compare) {
  CubeMap cube{.resolution = resolution};
  // >>> student: six faces without pixels, filters, wrap modes; a framebuffer with all faces as layers
  gl.GenTextures(1, &cube.texture);
  gl.BindTexture(GL_TEXTURE_CUBE_MAP, cube.texture);
  for (int face = 0; face < 6; ++face)
    gl.TexImage2D(GLenum(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face), 0, GLint(internal_format), resolution, resolution, 0,
                  GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
  const GLint filter = compare ? GL_LINEAR : GL_NEAREST;
  gl.TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, filter);
  gl.TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, filter);
  gl.TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_COMPARE_MODE, compare ? GL_COMPARE_REF_TO_TEXTURE : GL_NONE);
  gl.TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  gl.TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  gl.TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_R, GL_CLAMP_TO_EDGE);
  gl.BindTexture(GL_TEXTURE_CUBE_MAP, 0);
  gl.Enable(GL_TEXTURE_CUBE_MAP_SEAMLESS);

  gl.GenFramebuffers(1, &cube.framebuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, cube.framebuffer);
  gl.FramebufferTexture(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, cube.texture, 0);
  gl.DrawBuffer(GL_NONE);
  gl.ReadBuffer(GL_NONE);
  // --- skeleton
  // <<< student
  return cube;
}

void begin_cube_pass(Gl& gl, const CubeMap& cube, int face, bool cull_front_faces) {
  // >>> student: attach one face or the whole cube, set viewport, depth test, clamping and culling, clear
  gl.BindFramebuffer(GL_FRAMEBUFFER, cube.framebuffer);
  if (face < 0)
    gl.FramebufferTexture(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, cube.texture, 0);
  else
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GLenum(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face),
                            cube.texture, 0);
  gl.Viewport(0, 0, cube.resolution, cube.resolution);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LESS);
  gl.DepthMask(GL_TRUE);
  gl.Enable(GL_DEPTH_CLAMP);
  if (cull_front_faces) {
    gl.Enable(GL_CULL_FACE);
    gl.CullFace(GL_FRONT);
  } else {
    gl.Disable(GL_CULL_FACE);
  }
  gl.ClearDepth(1);
  gl.Clear(GL_DEPTH_BUFFER_BIT);
  // --- skeleton
  // <<< student
}

// ---- Core 1: the six views

glm::mat4 face_view(const glm::vec3& position, int face) {
  // >>> student: where each face looks, and which direction is up in it
  static const glm::vec3 ahead[6] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  static const glm::vec3 up[6] = {{0, -1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}, {0, -1, 0}, {0, -1, 0}};
  if (face < 0 || face > 5) throw std::invalid_argument("face_view: a cube has faces 0 to 5");
  return transforms::look_at(position, position + ahead[face], up[face]);
  // --- skeleton
  // | return glm::mat4(1.0f);
  // <<< student
}

glm::mat4 face_projection(float near, float far) {
  // >>> student: a quarter of a full turn
  return transforms::perspective(1.5707963f, 1, near, far);
  // --- skeleton
  // | return glm::mat4(1.0f);
  // <<< student
}

// ---- Further: point lights that need no cube

std::optional<Cone> cone_around(const glm::vec3& position, std::span<const Sphere> spheres, float widest) {
  // >>> student: the mean direction, then the widest angle from it
  glm::vec3 sum(0);
  for (const Sphere& sphere : spheres) {
    const glm::vec3 way = sphere.centre - position;
    const float distance = glm::length(way);
    if (distance <= sphere.radius) return {};
    sum += way / distance;
  }
  if (glm::length(sum) < 1e-4f) return {};
  Cone cone{.axis = glm::normalize(sum)};
  for (const Sphere& sphere : spheres) {
    const glm::vec3 way = sphere.centre - position;
    const float distance = glm::length(way);
    // The angle by atan2: acos of a cosine near 1 has lost its digits.
    const float off = std::atan2(glm::length(glm::cross(cone.axis, way)), glm::dot(cone.axis, way));
    cone.half_angle = std::max(cone.half_angle, off + std::asin(sphere.radius / distance));
  }
  if (cone.half_angle > widest) return {};
  return cone;
  // --- skeleton
  // | return {};
  // <<< student
}

}  // namespace atelier::point_shadows
