#include "scene_import/blinn_phong_of.hpp"

#include <algorithm>
#include <cmath>

namespace atelier::scene_import {
namespace {

constexpr float dielectric = 0.04f;  // reflectance of an index of refraction of 1.5

/// The texel of `image` at the centre of texel (x, y) of a picture of another size.
const Rgba& texel_at(const Image& image, int x, int y, const Image& like) {
  return image.at(int((x + 0.5) * image.width() / like.width()), int((y + 0.5) * image.height() / like.height()));
}

}  // namespace

float exponent_of_roughness(double roughness) {
  const double alpha = std::pow(std::clamp(roughness, 0.0, 1.0), 2);
  return float(std::clamp(2 / (alpha * alpha) - 2, 0.0, 10'000.0));
}

BlinnPhongColours of_metallic(const glm::vec3& base, float metallic) {
  const float m = std::clamp(metallic, 0.0f, 1.0f);
  return {base * (1 - m) * (1 - dielectric), glm::mix(glm::vec3(dielectric), base, m)};
}

BlinnPhongPictures of_metallic_pictures(const Image* base, const glm::vec3& base_factor, const Image* metallic,
                                        float metallic_factor) {
  const Image& like = base ? *base : *metallic;
  BlinnPhongPictures pictures{Image(like.width(), like.height()), Image(like.width(), like.height())};
  for (int y = 0; y < like.height(); ++y)
    for (int x = 0; x < like.width(); ++x) {
      const Rgba b = base ? base->at(x, y) : Rgba{1, 1, 1, 1};
      const float m = metallic ? texel_at(*metallic, x, y, like).b : 1.0f;
      const auto [diffuse, specular] = of_metallic(base_factor * glm::vec3(b.r, b.g, b.b), m * metallic_factor);
      pictures.diffuse.at(x, y) = {diffuse.r, diffuse.g, diffuse.b, b.a};
      pictures.specular.at(x, y) = {specular.r, specular.g, specular.b, 1};
    }
  return pictures;
}

double mean_of_channel(const Image& image, int channel) {
  double sum = 0;
  for (const Rgba& p : image.pixels()) sum += channel == 0 ? p.r : channel == 1 ? p.g : channel == 2 ? p.b : p.a;
  return image.empty() ? 0 : sum / double(image.pixels().size());
}

}  // namespace atelier::scene_import
