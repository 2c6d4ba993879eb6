// 03-shadow-mapping: the depth maps, and what the lights see. The contract is shadow_mapping.hpp.
#include "03-shadow-mapping/shadow_mapping.hpp"

namespace atelier::shadow_mapping {

// ---- Core 1: the map and the pass that draws it

ShadowMaps make_shadow_maps(Gl& gl, int resolution, int layers, GLenum internal_format, bool compare) {
  ShadowMaps maps{.resolution = resolution, .layers = layers};
  // >>> student: an array texture without pixels, its filters and border; a framebuffer with depth and without colour
  gl.GenTextures(1, &maps.texture);
  gl.BindTexture(GL_TEXTURE_2D_ARRAY, maps.texture);
  gl.TexImage3D(GL_TEXTURE_2D_ARRAY, 0, GLint(internal_format), resolution, resolution, layers, 0, GL_DEPTH_COMPONENT,
                GL_FLOAT, nullptr);
  const GLint filter = compare ? GL_LINEAR : GL_NEAREST;
  gl.TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, filter);
  gl.TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, filter);
  gl.TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_COMPARE_MODE, compare ? GL_COMPARE_REF_TO_TEXTURE : GL_NONE);
  gl.TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  const glm::vec4 farthest(1);
  gl.TexParameterfv(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BORDER_COLOR, &farthest[0]);
  gl.TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
  gl.TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
  gl.BindTexture(GL_TEXTURE_2D_ARRAY, 0);

  gl.GenFramebuffers(1, &maps.framebuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, maps.framebuffer);
  gl.FramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, maps.texture, 0, 0);
  gl.DrawBuffer(GL_NONE);
  gl.ReadBuffer(GL_NONE);
  // --- skeleton
  // <<< student
  return maps;
}

void begin_depth_pass(Gl& gl, const ShadowMaps& maps, int layer, bool cull_front_faces) {
  // >>> student: attach the layer, set viewport, depth test, clamping and culling, clear
  gl.BindFramebuffer(GL_FRAMEBUFFER, maps.framebuffer);
  gl.FramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, maps.texture, 0, layer);
  gl.Viewport(0, 0, maps.resolution, maps.resolution);
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

// ---- Core 2: what the light sees

LightFrustum fit_spot(const glm::vec3& position, const glm::vec3& direction, float outer_angle, const Sphere& sphere) {
  LightFrustum frustum{.eye = position, .direction = glm::normalize(direction)};
  // >>> student: look at the sphere, or along the light's own direction
  const glm::vec3 to_centre = sphere.centre - position;
  const float distance = glm::length(to_centre);
  frustum.extent = outer_angle;
  if (distance > sphere.radius) {
    const float touching = std::asin(sphere.radius / distance);
    if (touching <= outer_angle) {
      frustum.direction = to_centre / distance;
      frustum.extent = touching;
    }
  }
  frustum.extent = glm::clamp(frustum.extent, 0.001f, 1.5f);
  const float middle = glm::dot(to_centre, frustum.direction);
  frustum.far = std::max(middle + sphere.radius, 1e-6f);
  frustum.near = std::max(middle - sphere.radius, frustum.far / 1000);
  // --- skeleton
  // <<< student
  return frustum;
}

glm::mat4 light_view(const LightFrustum& frustum) {
  // >>> student: a camera at the eye that looks along the direction, exact also far from the origin
  return transforms::look_at(glm::vec3(0), frustum.direction, glm::vec3(0, 1, 0)) * transforms::translation(-frustum.eye);
  // --- skeleton
  // | return glm::mat4(1.0f);
  // <<< student
}

glm::mat4 light_projection(const LightFrustum& frustum) {
  // >>> student: a square pyramid or a square box
  if (frustum.orthographic)
    return transforms::orthographic(-frustum.extent, frustum.extent, -frustum.extent, frustum.extent, frustum.near,
                                    frustum.far);
  return transforms::perspective(2 * frustum.extent, 1, frustum.near, frustum.far);
  // --- skeleton
  // | return glm::mat4(1.0f);
  // <<< student
}

glm::mat4 bias_matrix() {
  // >>> student: from -1..1 to 0..1
  return {{0.5f, 0, 0, 0}, {0, 0.5f, 0, 0}, {0, 0, 0.5f, 0}, {0.5f, 0.5f, 0.5f, 1}};
  // --- skeleton
  // | return glm::mat4(1.0f);
  // <<< student
}

// ---- Further: directional lights

LightFrustum fit_directional(const glm::vec3& direction, const Sphere& sphere) {
  LightFrustum frustum{.orthographic = true, .direction = glm::normalize(direction)};
  // >>> student: the box that touches the sphere
  const float radius = std::max(sphere.radius, 1e-6f);
  frustum.eye = sphere.centre - radius * frustum.direction;
  frustum.extent = radius;
  frustum.near = 0;
  frustum.far = 2 * radius;
  // --- skeleton
  // <<< student
  return frustum;
}

// ---- Challenge: shadows that do not crawl

LightFrustum snap_to_texels(const LightFrustum& frustum, int resolution) {
  LightFrustum snapped = frustum;
  // >>> student: round the half-width up, then move the eye to the grid of texels
  if (!frustum.orthographic) return snapped;
  const float needed = frustum.extent * (1 + 1 / float(resolution));
  snapped.extent = std::exp2(std::ceil(4 * std::log2(needed)) / 4);
  const float texel = 2 * snapped.extent / float(resolution);
  const glm::mat4 to_light = transforms::look_at(glm::vec3(0), frustum.direction, glm::vec3(0, 1, 0));
  const glm::vec3 right(to_light[0][0], to_light[1][0], to_light[2][0]), up(to_light[0][1], to_light[1][1], to_light[2][1]);
  for (const glm::vec3& axis : {right, up}) {
    const float at = glm::dot(axis, frustum.eye);
    snapped.eye += (texel * std::floor(at / texel + 0.5f) - at) * axis;
  }
  // --- skeleton
  // <<< student
  return snapped;
}

}  // namespace atelier::shadow_mapping
