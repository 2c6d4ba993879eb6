// How near and how far a camera sees anything: near and far planes that fit the scene.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "scene/scene.hpp"

namespace atelier {

/// Depths along the way that a camera looks, in metres from the eye.
struct DepthRange {
  double near = 0, far = 0;
};

/// The box in world space around what each node draws: exact over its vertices and in double precision, then widened on
/// all sides by as much as floats may move a vertex, 6 units in the last place (1.2e-7) of the largest coordinate on
/// its way. That counts the places of all nodes and not only the box: below a root at a million metres a child that
/// leads back to the origin stands where floats put it, a centimetre beside its place. Empty for a node without
/// vertices.
std::vector<Box3> node_boxes(const Scene& scene);

/// The least and the greatest depth at which the pyramid of view (the slab of an orthographic camera) meets a box,
/// whatever the camera's own near and far. `aspect` is width / height of the picture. Exact up to the rounding of
/// doubles: each side of the box is clipped by the four side planes of the view. None where the box is out of sight.
std::optional<DepthRange> visible_depths(const Camera& camera, double aspect, const Box3& box);

/// `camera` with near and far as tight as the boxes allow, and within its own: what its own planes cut stays cut, and
/// no other pixel changes. `boxes` are those of `node_boxes`: they hold the vertices as floats place them in the world.
/// Both planes are widened by as much as floats may move a point from there into the view (6 units in the last place of
/// the largest coordinate of the camera and of the boxes that it sees, and 1e-5 of the depth itself). The camera as it
/// is where it sees none of the boxes.
///
/// It pays in precision: a depth buffer's steps at distance z are z^2 / near times those of the stored number (Reed,
/// "Depth Precision Visualized"), so a near plane ten times as far makes them ten times as fine.
Camera fit_depth(Camera camera, double aspect, std::span<const Box3> boxes);

}  // namespace atelier
