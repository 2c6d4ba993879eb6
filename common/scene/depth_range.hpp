// Fits near and far planes to the scene.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "scene/scene.hpp"

namespace atelier {

/// Depths along the view direction, in metres from the eye.
struct DepthRange {
  double near = 0, far = 0;
};

/// The bounding box of each node in world space: exact in double precision, then enlarged on all sides by the possible
/// float error of a vertex: 6 units in the last place (1.2e-7) of the largest coordinate in its computation. That
/// includes the translations of all nodes: if the root is at a million metres and a child moves back to the origin,
/// float error displaces the child by a centimetre. Empty for a node without vertices.
std::vector<Box3> node_boxes(const Scene& scene);

/// The least and the greatest depth of the part of a box that is inside the side planes of the view volume; the
/// camera's near and far planes are ignored. `aspect` is width / height of the picture. Exact up to double rounding:
/// each side of the box is clipped by the four side planes. None if the box is outside the view.
std::optional<DepthRange> visible_depths(const Camera& camera, double aspect, const Box3& box);

/// `camera` with near and far planes as tight as the boxes allow, but never outside its own planes, so no pixel
/// changes. `boxes` are those of `node_boxes`, which contain the vertices with their float error in world space. Both
/// planes are moved outwards by the possible float error from world to view space (6 units in the last place of the
/// largest coordinate of the camera and of the visible boxes, plus 1e-5 of the depth). Returns the camera unchanged if
/// no box is visible.
///
/// This improves precision: a depth buffer's steps at distance z are z^2 / near times those of the stored number (Reed,
/// "Depth Precision Visualized"), so a near plane ten times as far away makes them ten times as fine.
Camera fit_depth(Camera camera, double aspect, std::span<const Box3> boxes);

}  // namespace atelier
