// What the image of a light sees through its opening (Light::passage): the places behind the opening, and, carried
// through, those before it. Given.
#pragma once

#include <span>

#include "03-shadow-mapping/shadow_mapping.hpp"

namespace atelier {

/// A light's passage in the shaders' world space, from which `origin` is subtracted.
struct MovedPassage {
  glm::mat4 through{1};                     ///< from the world before the entry to the world behind the exit
  glm::vec4 entry_plane{0}, exit_plane{0};  ///< positive on the sides where casters stand
};
MovedPassage moved_passage(const Passage& passage, const glm::dvec3& origin);

/// The frustum around the opening of an image, with the near plane at the opening, and the far plane at the farthest of
/// `points` before the exit. A light that is very near to the plane of its opening has a frustum of 1.5 radians, which
/// misses what is lit at a grazing angle.
shadow_mapping::LightFrustum frustum_through(const Light& image, const glm::dvec3& origin,
                                             std::span<const glm::dvec3> points);

}  // namespace atelier
