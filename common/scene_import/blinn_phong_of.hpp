// Converts other material models to Blinn-Phong.
//
// Metallic-roughness (glTF 2.0, appendix B "BRDF implementation"): with base colour b, metallic m, roughness r,
//   F0 = mix(0.04, b, m)          reflectance at normal incidence; 0.04 is glass and plastic
//   kd = b (1 - m) (1 - 0.04)     metals have no diffuse part; only light that is not reflected is scattered
//   ks = F0
//   n  = 2 / r^4 - 2              glTF's alpha is r^2, and Blinn-Phong's lobe has about the width of a Beckmann lobe of
//                                 alpha where n = 2 / alpha^2 - 2 (Walter et al., "Microfacet models for refraction
//                                 through rough surfaces", 2007, section 5.2)
// Specular-glossiness (KHR_materials_pbrSpecularGlossiness): ks = s, kd = d (1 - max(s)), r = 1 - glossiness.
// n is at most 10 000: a perfect mirror would not show a light without extent.
//
// A material has a single exponent, so a roughness texture is replaced by its mean. A metallic texture changes colours
// per texel; it is baked into a diffuse and a specular texture.
#pragma once

#include "scene/scene.hpp"

namespace atelier::scene_import {

/// 0..1 (values outside are clamped) to 0..10000.
float exponent_of_roughness(double roughness);

struct BlinnPhongColours {
  glm::vec3 diffuse, specular;
};

/// The formulas above, for one colour.
BlinnPhongColours of_metallic(const glm::vec3& base, float metallic);

/// Linear textures that replace a base colour and a metallic texture (its blue channel, times `metallic_factor`). They
/// have the size of the base texture if there is one, otherwise of the metallic texture. At least one must be given.
struct BlinnPhongPictures {
  Image diffuse, specular;
};
BlinnPhongPictures of_metallic_pictures(const Image* base, const glm::vec3& base_factor, const Image* metallic,
                                        float metallic_factor);

/// The mean of a channel: 0 red .. 3 opacity.
double mean_of_channel(const Image& image, int channel);

}  // namespace atelier::scene_import
