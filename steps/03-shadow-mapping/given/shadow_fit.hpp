// Computes what a light's map must cover. Given.
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

/// The corners of the visible part of an item's box: the box, clipped to the six planes of the view. None if it is
/// outside the view.
std::vector<glm::dvec3> visible_corners(const ScenePainter::Item& item, const Viewpoint& viewpoint);

/// Convex pieces, each by its corners in world space.
using Pieces = std::vector<std::vector<glm::dvec3>>;

/// A tight superset of the visible receivers: the triangles of simple meshes (walls, boxes; a room's bounding box would
/// include its empty inside) and the boxes of others, clipped to the six planes of the view.
Pieces visible_receivers(const Scene& scene, std::span<const ScenePainter::Item> items, const Viewpoint& viewpoint);

/// The rectangle of a map's texels that these pieces cover, enlarged by `aside` texels: x, y, width, height. The whole
/// map if a piece is partly behind the light's plane.
glm::ivec4 texels_of(const Pieces& pieces, const glm::mat4& world_to_map, int resolution, float aside);

/// Whether any of the pieces may lie in the view of a cube's face, which is 90 degrees wide, enlarged on each side by a
/// fraction `aside` of its half-width. `view` takes world space to the face's, which looks along -z.
bool looks_into(const Pieces& pieces, const glm::mat4& view, float aside);

/// A bounding sphere of the points, with the centre of their bounding box; none without points.
std::optional<shadow_mapping::Sphere> sphere_around(std::span<const glm::dvec3> points);

/// Half the angle of a sphere seen from a point, radians. 4 (more than any angle) if the point is inside.
float radians_across(const shadow_mapping::Sphere& sphere, const glm::vec3& from);

/// Whether the cone of a spot at `position` does not intersect a sphere.
bool shines_past(const Light& spot, const glm::vec3& position, const shadow_mapping::Sphere& sphere);

/// The least depth of the points, metres along the frustum's direction from its eye; negative behind it.
float nearest_depth(std::span<const glm::dvec3> points, const shadow_mapping::LightFrustum& frustum);

/// A directional light's box around the overlap of casters and receivers, seen along the light: shadows fall nowhere
/// else. Like the student's fit_directional, with planes from the nearest caster to the farthest receiver. None if they
/// do not overlap.
std::optional<shadow_mapping::LightFrustum> fit_directional_to_both(const glm::vec3& direction,
                                                                    std::span<const glm::dvec3> casters,
                                                                    std::span<const glm::dvec3> receivers);

}  // namespace atelier
