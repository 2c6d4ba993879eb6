#include "oracle/shade.hpp"

#include "oracle/light.hpp"
#include "oracle/shadow.hpp"
#include "oracle/texture.hpp"

namespace atelier::oracle {

namespace {

const Material& material_of(const Scene& scene, const SurfacePoint& point) {
  return scene.materials[std::size_t(point.material)];
}

}  // namespace

Reflectance reflectance_at(const Scene& scene, const SurfacePoint& point) {
  const Material& material = material_of(scene, point);
  Reflectance found{glm::dvec3(material.diffuse), glm::dvec3(material.specular), double(material.exponent)};
  const auto multiply = [&](glm::dvec3& colour, const TextureIndex& texture) {
    if (texture) colour *= texel_colour(scene.textures[std::size_t(*texture)], point.texcoord);
  };
  multiply(found.diffuse, material.diffuse_texture);
  multiply(found.specular, material.specular_texture);
  return found;
}

glm::dvec3 shade(const World& world, const SurfacePoint& point, const glm::dvec3& eye, const Shading& shading,
                 Part part) {
  const Scene& scene = world.scene();
  if (shading.surface) return shading.surface(world, point, eye);

  Reflectance surface = reflectance_at(scene, point);
  surface.normalisation = shading.normalisation;
  if (part == Part::diffuse) surface.specular = glm::dvec3(0);
  if (part == Part::specular) surface.diffuse = glm::dvec3(0);
  glm::dvec3 sum = surface.diffuse * glm::dvec3(scene.ambient);
  if (part == Part::all) sum += glm::dvec3(material_of(scene, point).emission);

  const glm::dvec3 to_eye = eye - point.position;
  if (point.normal == glm::dvec3(0) || to_eye == glm::dvec3(0)) return sum;
  const auto add = [&](const Light& light, const auto& source) {
    const Arriving found = arriving(light, point.position);
    const glm::dvec3 share = reflected(surface, point.normal, glm::normalize(to_eye), found.to_light);
    if (found.amount * share == glm::dvec3(0)) return;  // nothing to shade
    sum += visibility(world, point, source, shading) * found.amount * share;
  };
  for (const Light& light : scene.lights) add(light, light);
  if (shading.portal_lights)
    for (const LightImage& image : world.images()) add(image.light, image);
  return sum;
}

}  // namespace atelier::oracle
