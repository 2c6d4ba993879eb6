// 03-shadow-mapping: the depth maps, and what the lights see. The contract is shadow_mapping.hpp.
#include "03-shadow-mapping/shadow_mapping.hpp"

namespace atelier::shadow_mapping {

// ---- Core 1: the map and the pass that draws it

ShadowMaps make_shadow_maps(Gl& gl, int resolution, int layers, GLenum internal_format, bool compare) {
  ShadowMaps maps{.resolution = resolution, .layers = layers};
  // TODO(03-shadow-mapping): an array texture without pixels, its filters and border; a framebuffer with depth and without colour
  return maps;
}

void begin_depth_pass(Gl& gl, const ShadowMaps& maps, int layer, bool cull_front_faces) {
  // TODO(03-shadow-mapping): attach the layer, set viewport, depth test, clamping and culling, clear
}

// ---- Core 2: what the light sees

LightFrustum fit_spot(const glm::vec3& position, const glm::vec3& direction, float outer_angle, const Sphere& sphere) {
  LightFrustum frustum{.eye = position, .direction = glm::normalize(direction)};
  // TODO(03-shadow-mapping): look at the sphere, or along the light's own direction
  return frustum;
}

glm::mat4 light_view(const LightFrustum& frustum) {
  // TODO(03-shadow-mapping): a camera at the eye that looks along the direction, exact also far from the origin
  return glm::mat4(1.0f);
}

glm::mat4 light_projection(const LightFrustum& frustum) {
  // TODO(03-shadow-mapping): a square pyramid or a square box
  return glm::mat4(1.0f);
}

glm::mat4 bias_matrix() {
  // TODO(03-shadow-mapping): from -1..1 to 0..1
  return glm::mat4(1.0f);
}

// ---- Further: directional lights

LightFrustum fit_directional(const glm::vec3& direction, const Sphere& sphere) {
  LightFrustum frustum{.orthographic = true, .direction = glm::normalize(direction)};
  // TODO(03-shadow-mapping): the box that touches the sphere
  return frustum;
}

// ---- Challenge: shadows that do not crawl

LightFrustum snap_to_texels(const LightFrustum& frustum, int resolution) {
  LightFrustum snapped = frustum;
  // TODO(03-shadow-mapping): round the half-width up, then move the eye to the grid of texels
  return snapped;
}

}  // namespace atelier::shadow_mapping
