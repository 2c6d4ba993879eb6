// 03-shadow-mapping: the depth maps, and what the lights see. What each function must do stands in shadow_mapping.hpp.
#include "03-shadow-mapping/shadow_mapping.hpp"

namespace atelier::shadow_mapping {

// ---- Core 1: the map and the pass that draws it

ShadowMaps make_shadow_maps(Gl& gl, int resolution, int layers, GLenum internal_format, bool compare) {
  ShadowMaps maps{.resolution = resolution, .layers = layers};
  // TODO(03-shadow-mapping): an array texture without pixels, its filters, its border; a framebuffer with depth and no colour
  return maps;
}

void begin_depth_pass(Gl& gl, const ShadowMaps& maps, int layer, bool cull_front_faces) {
  // TODO(03-shadow-mapping): attach the layer, set viewport, depth test, clamping and culling, clear
}

// ---- Core 2: what the light sees

LightFrustum fit_spot(const glm::vec3& position, const glm::vec3& direction, float outer_angle, const Sphere& sphere) {
  LightFrustum frustum{.eye = position, .direction = glm::normalize(direction)};
  // TODO(03-shadow-mapping): look at the sphere, or along the cone where that is narrower or the light within the sphere
  return frustum;
}

glm::mat4 light_view(const LightFrustum& frustum) {
  // TODO(03-shadow-mapping): step 01's camera; eye + direction would lose the direction's digits far from the origin
  return glm::mat4(1.0f);
}

glm::mat4 light_projection(const LightFrustum& frustum) {
  // TODO(03-shadow-mapping): step 01's projections; the map is square
  return glm::mat4(1.0f);
}

glm::mat4 bias_matrix() {
  // TODO(03-shadow-mapping): x/2 + w/2, and so for y and z
  return glm::mat4(1.0f);
}

// ---- Further: a sun

LightFrustum fit_directional(const glm::vec3& direction, const Sphere& sphere) {
  LightFrustum frustum{.orthographic = true, .direction = glm::normalize(direction)};
  // TODO(03-shadow-mapping): the sphere's radius is all that it takes
  return frustum;
}

// ---- Challenge: shadows that stand still

LightFrustum snap_to_texels(const LightFrustum& frustum, int resolution) {
  LightFrustum snapped = frustum;
  // TODO(03-shadow-mapping): round the half-width up to a step, then the eye to the grid of texels
  return snapped;
}

}  // namespace atelier::shadow_mapping
