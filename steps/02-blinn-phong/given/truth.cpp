#include "02-blinn-phong/given/truth.hpp"

#include <algorithm>
#include <cmath>

#include "02-blinn-phong/given/blind.hpp"
#include "02-blinn-phong/given/scenes.hpp"
#include "image/colour.hpp"
#include "scene/builder.hpp"

namespace atelier {

namespace {

/// diffuse + specular at most 1 in every channel, by one factor for both.
void balance_exactly(Material& material) {
  const glm::dvec3 sum = glm::dvec3(material.diffuse) + glm::dvec3(material.specular);
  const double largest = std::max({sum.r, sum.g, sum.b});
  if (largest <= 1) return;
  material.diffuse = glm::vec3(glm::dvec3(material.diffuse) / largest);
  material.specular = glm::vec3(glm::dvec3(material.specular) / largest);
}

void adjust_exactly(Scene& scene, const Settings& settings) {
  const double exponent = settings.real("material.exponent");
  for (Material& material : scene.materials) {
    if (exponent >= 0) material.exponent = float(exponent);
    if (settings.flag("material.balance")) balance_exactly(material);
  }
}

/// The linear light of the picture after 8-bit sRGB encoding, as in the step's textures.
Image as_stored(Image image) {
  const auto stored = [](float linear) { return float(srgb_decode(double(srgb_code(linear)) / 255)); };
  for (Rgba& p : image.pixels()) p = {stored(p.r), stored(p.g), stored(p.b), p.a};
  return image;
}

void prepare_textures(Scene& scene, const std::string& filter) {
  std::vector<bool> coloured(scene.textures.size(), false);
  for (const Material& material : scene.materials)
    for (const TextureIndex& index : {material.diffuse_texture, material.specular_texture})
      if (index) coloured[std::size_t(*index)] = true;
  for (std::size_t i = 0; i < scene.textures.size(); ++i) {
    Texture& texture = scene.textures[i];
    if (coloured[i]) texture.pixels = as_stored(std::move(texture.pixels));
    if (filter != "scene") texture.filter = filter == "nearest" ? Filter::nearest : Filter::linear;
  }
}

oracle::Normalisation normalisation_named(const std::string& name) {
  return name == "n+8"     ? oracle::Normalisation::n_plus_8
         : name == "exact" ? oracle::Normalisation::exact
                           : oracle::Normalisation::none;
}

/// The blind's transmission at this x.
double through_slats(double x) {
  const BlindShape& blind = blind_shape;
  const double off_middle = std::abs(std::remainder(x - blind.period / 2, blind.period));
  const double t = std::clamp((off_middle - blind.period / 4) / blind.ramp + 0.5, 0.0, 1.0);
  return (1 + t * t * (3 - 2 * t)) / 2;
}

/// The blind's transmission where the ray from the position to the light crosses its plane.
double through_blind(const Light& light, const glm::dvec3& position) {
  const bool endless = light.type == LightType::directional;
  const glm::dvec3 way = endless ? -glm::dvec3(light.direction) : light.position - position;
  const double plane = endless ? blind_shape.height : light.position.y - blind_shape.below;
  if (way.y == 0) return 1;
  const double t = (plane - position.y) / way.y;
  return t > 0 && (endless || t < 1) ? through_slats(position.x + t * way.x) : 1;
}

}  // namespace

SceneTruth blinn_phong_truth(const TruthRequest& request, const Settings& settings, std::optional<Scene> model) {
  SceneTruth truth;
  if (model) {
    truth.scene = std::move(*model);
  } else {
    truth.scene = make_scene(unadjusted_blinn_phong_scenes(), request.scene, settings);
    adjust_exactly(truth.scene, settings);
  }
  const auto lights = std::size_t(settings.integer("light.count"));
  if (truth.scene.lights.size() > lights) truth.scene.lights.resize(lights);
  prepare_textures(truth.scene, settings.choice("texture.filter"));
  truth.shading.normalisation = normalisation_named(settings.choice("specular.normalisation"));
  // Later steps have no blinds.
  if (settings.has("light.blind") && settings.flag("light.blind")) truth.shading.share = through_blind;
  if (request.output == "encoded") {
    truth.output = "colour";
    set_background(truth.scene, glm::vec3(0));  // as for every output except colour
    truth.finish = [](Image image) { return srgb_encode(image); };
  }
  return truth;
}

}  // namespace atelier
