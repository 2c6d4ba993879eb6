#include "oracle/light_image.hpp"

#include <cmath>
#include <limits>

#include "oracle/portal.hpp"
#include "scene/opening.hpp"

namespace atelier::oracle {

namespace {

/// In a frame's space: where a light is, or, of a directional one, the direction from which it shines.
double height_over(const glm::dmat4& frame, const Light& light) {
  const glm::dvec3 up(frame[2]);
  return light.type == LightType::directional ? -glm::dot(up, glm::dvec3(light.direction))
                                              : glm::dot(up, light.position - glm::dvec3(frame[3]));
}

Light carried(Light light, const glm::dmat4& through) {
  light.position = glm::dvec3(through * glm::dvec4(light.position, 1));
  light.direction = glm::vec3(through * glm::dvec4(glm::dvec3(light.direction), 0));
  return light;
}

}  // namespace

std::vector<LightImage> light_images(const Scene& scene) {
  std::vector<LightImage> images;
  if (scene.portals.empty()) return images;
  const std::vector<glm::dmat4> world = world_matrices_exact(scene.nodes);
  for (const Portal& portal : scene.portals) {
    const Node& node = scene.nodes[std::size_t(portal.node)];
    const glm::dmat4& entry = world[std::size_t(portal.node)];
    const glm::dmat4& exit = world[std::size_t(portal.exit.value_or(portal.node))];
    const glm::dmat4 through = passage_of(portal, world);
    const bool two_sided = scene.materials[std::size_t(node.material)].two_sided;
    const glm::dvec2 half_size = half_size_of(scene, portal);
    for (const Light& light : scene.lights) {
      const double height = height_over(entry, light);
      if (height == 0 || (height < 0 && !two_sided)) continue;
      const glm::dmat4 side = height > 0 ? exit : glm::dmat4(-exit[0], exit[1], -exit[2], exit[3]);
      images.push_back({carried(light, through), glm::inverse(through), glm::inverse(side), half_size});
    }
  }
  return images;
}

std::optional<WayToImage> way_to(const LightImage& image, const glm::dvec3& position, double gap) {
  const bool endless = image.light.type == LightType::directional;
  const glm::dvec3 way = endless ? -glm::normalize(glm::dvec3(image.light.direction)) : image.light.position - position;
  const glm::dvec3 p(image.world_to_exit * glm::dvec4(position, 1)), d(image.world_to_exit * glm::dvec4(way, 0));
  if (!(p.z > 0 && d.z < 0)) return {};
  const double met = p.z / -d.z;
  const glm::dvec3 at = p + met * d;
  if (std::abs(at.x) > image.half_size.x || std::abs(at.y) > image.half_size.y) return {};
  const double margin = gap / glm::length(way);
  const auto carried_back = [&](const glm::dvec3& v, double w) { return glm::dvec3(image.back * glm::dvec4(v, w)); };
  return WayToImage{{.origin = position, .direction = way, .least = 0, .most = met - margin},
                    {.origin = carried_back(position, 1),
                     .direction = carried_back(way, 0),
                     .least = met + margin,
                     .most = endless ? std::numeric_limits<double>::infinity() : 1 - margin}};
}

}  // namespace atelier::oracle
