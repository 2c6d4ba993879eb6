// Which boxes a view cannot see.
#pragma once

#include <glm/glm.hpp>

#include "scene/scene.hpp"

namespace atelier {

/// Whether the whole of an object's box lies outside the clip volume, on the far side of one of its six planes; true
/// also for an empty box. `model`, `view` and `projection` take object space to world, view and clip space; depth runs
/// from -w to w, or from 0 to w where `depth_from_zero`. Never true for a box of which anything can be drawn, also
/// where the shader, which works in floats, computes something else than these matrices say: far from the origin it
/// subtracts large numbers from each other, so the slack is a share of the largest numbers on the way and not of the
/// result. At a million metres that is some ten metres. A few boxes near an edge of the volume are let pass although
/// nothing of them is seen (Assarsson and Moeller, "Optimized View Frustum Culling Algorithms for Bounding Boxes",
/// Journal of Graphics Tools 5(1), 2000).
bool outside_view(const glm::mat4& projection, const glm::mat4& view, const glm::mat4& model, const Box3& box,
                  bool depth_from_zero = false);

}  // namespace atelier
