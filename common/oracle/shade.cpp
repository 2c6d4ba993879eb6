#include "oracle/shade.hpp"

#include <algorithm>
#include <cmath>

#include "oracle/light.hpp"
#include "oracle/texture.hpp"

namespace atelier::oracle {

namespace {

const Material& material_of(const Scene& scene, const SurfacePoint& point) {
  return scene.materials[std::size_t(point.material)];
}

double largest_component(const glm::dvec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
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

bool in_shadow(const World& world, const SurfacePoint& point, const Light& light) {
  if (!light.casts_shadow || !point.receives_shadow) return false;
  const bool directional = light.type == LightType::directional;
  const glm::dvec3 way = directional ? -glm::normalize(glm::dvec3(light.direction)) : light.position - point.position;
  // The point itself is known to a few parts in 1e16 of its coordinates: start a little off the surface, on the side
  // that the light is on, so that a surface does not shade itself.
  const double gap = 1e-11 * (largest_component(point.position) + (directional ? 1 : glm::length(way)));
  const glm::dvec3 off = point.flat_normal * (glm::dot(point.flat_normal, way) < 0 ? -gap : gap);
  if (directional) return world.blocked({point.position + off, way});
  return world.blocked({point.position + off, way - off, 0, 1});
}

glm::dvec3 shade(const World& world, const SurfacePoint& point, const glm::dvec3& eye, const Shading& shading,
                 Part part) {
  const Scene& scene = world.scene();
  if (shading.surface) return shading.surface(scene, point, eye);

  Reflectance surface = reflectance_at(scene, point);
  surface.normalisation = shading.normalisation;
  if (part == Part::diffuse) surface.specular = glm::dvec3(0);
  if (part == Part::specular) surface.diffuse = glm::dvec3(0);
  glm::dvec3 sum = surface.diffuse * glm::dvec3(scene.ambient);
  if (part == Part::all) sum += glm::dvec3(material_of(scene, point).emission);

  const glm::dvec3 to_eye = eye - point.position;
  if (point.normal == glm::dvec3(0) || to_eye == glm::dvec3(0)) return sum;
  for (const Light& light : scene.lights) {
    const Arriving found = arriving(light, point.position);
    const glm::dvec3 share = reflected(surface, point.normal, glm::normalize(to_eye), found.to_light);
    if (found.amount * share == glm::dvec3(0)) continue;  // nothing to shade
    if (shading.hard_shadows && in_shadow(world, point, light)) continue;
    sum += found.amount * share;
  }
  return sum;
}

}  // namespace atelier::oracle
