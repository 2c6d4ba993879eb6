// What a light's map must cover. Given.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "03-shadow-mapping/shadow_mapping.hpp"
#include "render/feature.hpp"

namespace atelier {

bool casts(const Scene& scene, const ScenePainter::Item& item);
bool receives(const Scene& scene, const ScenePainter::Item& item);

/// The corners of an item's box, in world space.
std::array<glm::dvec3, 8> corners_of(const ScenePainter::Item& item);

/// The corners of that part of an item's box which the camera sees: the box, cut by the six planes of the view. None
/// where it is out of sight.
std::vector<glm::dvec3> visible_corners(const ScenePainter::Item& item, const Viewpoint& viewpoint);

/// Convex pieces, each by its corners in world space.
using Pieces = std::vector<std::vector<glm::dvec3>>;

/// All that the camera sees of what receives shadows lies in these, and little else: the triangles of plain meshes
/// (walls, boxes: a room's box would hold the air in it) and the boxes of others, cut by the six planes of the view.
Pieces visible_receivers(const Scene& scene, std::span<const ScenePainter::Item> items, const Viewpoint& viewpoint);

/// The rectangle of texels of a map that these pieces fall into, and so many texels around it: x, y, width, height. All
/// of the map where something lies behind the light's plane.
glm::ivec4 texels_of(const Pieces& pieces, const glm::mat4& world_to_map, int resolution, float aside);

/// Whether any of the pieces may lie in the view of a cube's face, which is a right angle wide and on each side by a
/// fraction `aside` of its half-width more. `view` takes world space to the face's, which looks along -z.
bool looks_into(const Pieces& pieces, const glm::mat4& view, float aside);

/// A sphere around the middle of the points' bounding box that holds them all; none around no points.
std::optional<shadow_mapping::Sphere> sphere_around(std::span<const glm::dvec3> points);

/// Half the angle that a sphere takes up, seen from a point: radians. 4, more than any angle, from within it.
float radians_across(const shadow_mapping::Sphere& sphere, const glm::vec3& from);

/// Whether the cone of a spot that stands at `position` misses all of a sphere.
bool shines_past(const Light& spot, const glm::vec3& position, const shadow_mapping::Sphere& sphere);

/// Of the points, metres along the frustum's direction from its eye; negative behind it.
float nearest_depth(std::span<const glm::dvec3> points, const shadow_mapping::LightFrustum& frustum);

/// The box of a directional light around what casters and receivers have in common, seen along its light: a shadow
/// falls nowhere else. The student's fit_directional, with planes that run from the nearest caster to the farthest
/// receiver. None where they have nothing in common.
std::optional<shadow_mapping::LightFrustum> fit_directional_to_both(const glm::vec3& direction,
                                                                    std::span<const glm::dvec3> casters,
                                                                    std::span<const glm::dvec3> receivers);

}  // namespace atelier
