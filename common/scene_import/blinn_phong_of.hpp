// Other models' materials as Blinn-Phong.
//
// Metallic-roughness (glTF 2.0, appendix B "BRDF implementation"): with base colour b, metallic m, roughness r,
//   F0 = mix(0.04, b, m)          what is mirrored straight back; 0.04 is glass and plastic
//   kd = b (1 - m) (1 - 0.04)     metals have no diffuse part; what is mirrored cannot be scattered, too
//   ks = F0
//   n  = 2 / r^4 - 2              glTF's alpha is r^2, and Blinn-Phong's lobe has about the width of a Beckmann lobe of
//                                 alpha where n = 2 / alpha^2 - 2 (Walter et al., "Microfacet models for refraction
//                                 through rough surfaces", 2007, section 5.2)
// Specular-glossiness (KHR_materials_pbrSpecularGlossiness): ks = s, kd = d (1 - max(s)), r = 1 - glossiness.
// n ends at 10 000: of a light without extent, a mirror would show nothing at all.
//
// A material here has one exponent, so that a picture of roughness counts by its mean. Pictures of metallic change
// colours from texel to texel; they are multiplied out into a diffuse and a specular picture.
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

/// Linear pictures that stand in for a base colour and a picture of metallic (its blue channel, times
/// `metallic_factor`); as large as the base picture where there is one, otherwise as the metallic picture. At least one
/// must be there.
struct BlinnPhongPictures {
  Image diffuse, specular;
};
BlinnPhongPictures of_metallic_pictures(const Image* base, const glm::vec3& base_factor, const Image* metallic,
                                        float metallic_factor);

/// The mean of a channel: 0 red .. 3 opacity.
double mean_of_channel(const Image& image, int channel);

}  // namespace atelier::scene_import
