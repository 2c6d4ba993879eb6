// A light's map and shadow coordinates in double precision, from the contract's formulas and the oracle's camera,
// without calling code of the student or the renderer. Given.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "scene/scene.hpp"

namespace atelier {

/// What the map of a light is fitted to ("shadow.fit").
enum class MapFit {
  scene,   ///< a sphere around all casters and receivers
  casters  ///< a sphere around all casters
};

/// A light's frustum, like LightFrustum of the contract.
struct ExactFrustum {
  bool orthographic = false;
  glm::dvec3 eye{0}, direction{0, -1, 0};
  double extent = 1;           ///< half the field of view, radians; orthographic: half the width, metres
  double near = 0.1, far = 1;  ///< metres along the direction
};

/// The corners of the casters' boxes, eight per node, in world space; each box is aligned with its object's axes.
std::vector<glm::dvec3> caster_corners_exact(const Scene& scene);

/// The frustum of a light's map; none if the light has no map: a point light, a light that casts no shadows, or one
/// without casters in its reach or, for a spot, in its cone. A spot's near plane is at 99 % of the distance to the
/// nearest caster's box, as in the given program. Throws Error as world_matrices_exact does.
std::optional<ExactFrustum> exact_frustum(const Scene& scene, const Light& light, MapFit fit);

/// The shadow coordinate of a point in world space: shadow_coordinate of the contract.
glm::dvec3 exact_shadow_coordinate(const ExactFrustum& frustum, const glm::dvec3& position);

/// A camera with the light's view, also including what is in front of its near plane and behind its far plane.
Camera camera_of(const ExactFrustum& frustum);

/// The scene of the depth pass: only casters, two-sided or, with `back_faces_only`, only back faces. The background is
/// 1, the farthest depth.
Scene casters_alone(Scene scene, bool back_faces_only);

}  // namespace atelier
