// View frustum culling of boxes.
#pragma once

#include <glm/glm.hpp>

#include "scene/scene.hpp"

namespace atelier {

/// Whether an object's box is completely outside one of the six planes of the clip volume; also true for an empty box.
/// `model`, `view` and `projection` map object space to world, view and clip space; depth is from -w to w, or from 0 to
/// w if `depth_from_zero`. Conservative: never true if a part of the box could be drawn, including float error in the
/// shader. Far from the origin the shader subtracts large numbers, so the slack is relative to the largest intermediate
/// values; at a million metres it is about ten metres. Some invisible boxes near an edge of the volume are not culled
/// (Assarsson and Moeller, "Optimized View Frustum Culling Algorithms for Bounding Boxes", Journal of Graphics Tools
/// 5(1), 2000).
bool outside_view(const glm::mat4& projection, const glm::mat4& view, const glm::mat4& model, const Box3& box,
                  bool depth_from_zero = false);

}  // namespace atelier
