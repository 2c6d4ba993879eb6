// 04-point-shadows: the cube map, and what a point light sees all around. The contract is point_shadows.hpp.
#include "04-point-shadows/point_shadows.hpp"

namespace atelier::point_shadows {

// ---- Core 1: the cube and the pass that draws it

CubeMap make_cube_map(Gl& gl, int resolution, GLenum internal_format, bool compare) {
  CubeMap cube{.resolution = resolution};
  // TODO(04-point-shadows): six faces without pixels, filters, wrap modes; a framebuffer with all faces as layers
  return cube;
}

void begin_cube_pass(Gl& gl, const CubeMap& cube, int face, bool cull_front_faces) {
  // TODO(04-point-shadows): attach one face or the whole cube, set viewport, depth test, clamping and culling, clear
}

// ---- Core 1: the six views

glm::mat4 face_view(const glm::vec3& position, int face) {
  // TODO(04-point-shadows): where each face looks, and which direction is up in it
  return glm::mat4(1.0f);
}

glm::mat4 face_projection(float near, float far) {
  // TODO(04-point-shadows): a quarter of a full turn
  return glm::mat4(1.0f);
}

// ---- Further: point lights that need no cube

std::optional<Cone> cone_around(const glm::vec3& position, std::span<const Sphere> spheres, float widest) {
  // TODO(04-point-shadows): the mean direction, then the widest angle from it
  return {};
}

}  // namespace atelier::point_shadows
