// What a light's map covers and where a point lies in it, once more: in double precision, from the contract's formulas
// and the oracle's own camera, without a call of the student's or of the renderer's. Given.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "scene/scene.hpp"

namespace atelier {

/// What the map of a light is fitted to ("shadow.fit").
enum class MapFit {
  scene,   ///< a sphere around all that casts or receives shadows
  casters  ///< a sphere around all that casts shadows
};

/// What a light sees, as LightFrustum of the contract has it.
struct ExactFrustum {
  bool orthographic = false;
  glm::dvec3 eye{0}, direction{0, -1, 0};
  double extent = 1;           ///< half the angle of view, radians; orthographic: half the width, metres
  double near = 0.1, far = 1;  ///< metres along the direction
};

/// The corners of the boxes of all that casts shadows, eight a node: each box lies along its object's own axes. World
/// space.
std::vector<glm::dvec3> caster_corners_exact(const Scene& scene);

/// The frustum of a light's map; none where the light has no map: it is a point light, it casts no shadows, or nothing
/// that casts them is within its reach or, of a spot, within its cone. A spot's near plane is moved to 99 % of the way
/// to the nearest caster's box, as the given program does. Throws Error as world_matrices_exact does.
std::optional<ExactFrustum> exact_frustum(const Scene& scene, const Light& light, MapFit fit);

/// The shadow coordinate of a point in world space: shadow_coordinate of the contract.
glm::dvec3 exact_shadow_coordinate(const ExactFrustum& frustum, const glm::dvec3& position);

/// A camera that sees what the light sees, and also what stands before its near plane and behind its far plane.
Camera camera_of(const ExactFrustum& frustum);

/// The scene as the depth pass draws it: what casts shadows and nothing else, seen from both sides, or, with
/// `back_faces_only`, from behind alone. Where nothing is seen, it is 1: the farthest depth.
Scene casters_alone(Scene scene, bool back_faces_only);

}  // namespace atelier
