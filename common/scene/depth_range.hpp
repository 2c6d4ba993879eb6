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

/// The box in world space around what each node draws, exact over its vertices and in double precision; empty for a
/// node without a mesh.
std::vector<Box3> node_boxes(const Scene& scene);

/// The least and the greatest depth at which the pyramid of view (the slab of an orthographic camera) meets a box,
/// whatever the camera's own near and far. `aspect` is width / height of the picture. Exact up to the rounding of
/// doubles: each side of the box is clipped by the four side planes of the view. None where the box is out of sight.
std::optional<DepthRange> visible_depths(const Camera& camera, double aspect, const Box3& box);

/// `camera` with near and far as tight as the boxes allow, and within its own: what its own planes cut stays cut, and
/// no other pixel changes. Both are widened by as much as floats may move a point (6 units in the last place of the
/// largest coordinate, and 1e-5 of the depth itself). The camera as it is where it sees none of the boxes.
///
/// It pays in precision: a depth buffer's steps at distance z are z^2 / near times those of the stored number (Reed,
/// "Depth Precision Visualized"), so a near plane ten times as far makes them ten times as fine.
Camera fit_depth(Camera camera, double aspect, std::span<const Box3> boxes);

}  // namespace atelier
