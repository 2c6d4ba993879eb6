#include "scene/light_reach.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "scene/depth_range.hpp"

namespace atelier {
namespace {

/// Shaders compare the cone's edge as a float cosine. Near the axis a rounding error of 1e-7 is an angle of 5e-4; a
/// spot must miss the box by more than that.
constexpr double cone_slack = 2e-3;  // radians

/// Margin for float rounding: a few operations with 6e-8 each.
constexpr double rounding = 1.0001;

double distance_to(const Box3& box, const glm::dvec3& point) {
  return glm::length(point - glm::clamp(point, box.low, box.high));
}

/// Whether the spot's cone and the cone around the box's bounding sphere, seen from the spot, do not intersect: the
/// angle between their axes is larger than the sum of their half-angles.
bool misses(const Light& spot, const Box3& box) {
  const glm::dvec3 centre = (box.low + box.high) / 2.0, to_centre = centre - spot.position;
  const double radius = glm::length(box.high - box.low) / 2, distance = glm::length(to_centre);
  if (distance <= radius) return false;
  const double cosine = glm::dot(to_centre / distance, glm::normalize(glm::dvec3(spot.direction)));
  const double between = std::acos(std::clamp(cosine, -1.0, 1.0));
  return between > std::asin(radius / distance) + double(spot.outer_angle) + cone_slack;
}

double largest(const glm::dvec3& v) {
  return std::max({v.r, v.g, v.b});
}

}  // namespace

glm::dvec3 most_arriving(const Light& light, const Box3& box) {
  const glm::dvec3 colour(light.colour);
  if (box.empty()) return glm::dvec3(0);
  if (light.type == LightType::directional) return colour;
  if (light.type == LightType::spot && misses(light, box)) return glm::dvec3(0);
  const double d = std::max(distance_to(box, light.position), 0.001);
  const glm::dvec3 c(light.attenuation);
  return colour / (c.x + c.y * d + c.z * d * d);
}

glm::dvec3 most_given_back(const std::vector<Material>& materials, const std::function<double(double)>& peak) {
  glm::dvec3 most(0);
  for (const Material& material : materials) {
    const glm::dvec3 specular(material.specular);
    const double height = material.specular == glm::vec3(0) ? 0 : peak(double(material.exponent));
    most = glm::max(most, glm::dvec3(material.diffuse) + specular * height);
  }
  return most;
}

Box3 box_of_drawn(std::span<const Box3> node_boxes) {
  Box3 all;
  for (const Box3& box : node_boxes) all.add(box);
  return all;
}

std::vector<int> lights_that_matter(const std::vector<Light>& lights, const glm::dvec3& given_back, const Box3& box,
                                    std::span<const int> among) {
  std::vector<glm::dvec3> gives;
  for (const Light& light : lights) gives.push_back(most_arriving(light, box) * given_back * rounding);
  const auto gift = [&](int light) { return gives[std::size_t(light)]; };
  glm::dvec3 left_out(0);
  for (int i = 0; i < int(lights.size()); ++i)
    if (!std::ranges::binary_search(among, i)) left_out += gift(i);
  std::vector<int> order(among.begin(), among.end());
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return largest(gift(a)) < largest(gift(b)); });

  std::size_t first_kept = 0;
  for (; first_kept < order.size(); ++first_kept) {
    left_out += gift(order[first_kept]);
    if (!(largest(left_out) < least_visible_light)) break;
  }
  std::vector<int> kept(order.begin() + std::ptrdiff_t(first_kept), order.end());
  std::sort(kept.begin(), kept.end());
  return kept;
}

std::vector<int> lights_that_matter(const std::vector<Light>& lights, const glm::dvec3& given_back, const Box3& box) {
  std::vector<int> all(lights.size());
  std::iota(all.begin(), all.end(), 0);
  return lights_that_matter(lights, given_back, box, all);
}

}  // namespace atelier
