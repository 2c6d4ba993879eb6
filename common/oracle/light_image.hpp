// Light that goes through portals or is reflected by mirrors, once: an image of a light behind each exit.
#pragma once

#include <vector>

#include "oracle/ray.hpp"
#include "scene/scene.hpp"

namespace atelier::oracle {

/// A light as it is seen in an opening.
struct LightImage {
  Light light;                  ///< carried through the opening: it lies behind the exit
  glm::dmat4 back{1};           ///< from the exit's side back to the entry's: world space
  glm::dmat4 world_to_exit{1};  ///< its light comes out along the frame's +z
  glm::dvec2 half_size{0};      ///< of the rectangle around the opening, in the exit's plane z = 0
};

/// Those of all lights and openings of a valid scene where the light shines on the opening's front, or on any side of
/// a two-sided one.
std::vector<LightImage> light_images(const Scene& scene);

/// The straight way from a point to an image: before the exit, and from the entry to the light itself.
struct WayToImage {
  Ray to_exit, to_light;
};
/// None if the way does not lead through the opening's rectangle, from its front. `gap`: both parts end, or begin, so
/// many metres from the opening.
std::optional<WayToImage> way_to(const LightImage& image, const glm::dvec3& position, double gap);

}  // namespace atelier::oracle
