// The ground truth of step 06's pictures. Calls no function of the student's. Given.
#pragma once

#include "app/scene_truth.hpp"

namespace atelier {

/// The step's scenes as in step 05's truth, in which reliefs are real: every node called relief_node is replaced by a
/// height field, a bilinear patch for each square of four texels, and every node called round_relief_node by a fine
/// mesh of its points; other surfaces stay as flat as their triangles. Ignored: all settings that only trade accuracy
/// for speed. "parallax.method" none and "parallax.depth" 0 leave the surface flat; "parallax.shadow_samples" 0 leaves
/// out the relief's shadows. Throws Error for an unknown scene, and for a range of recorded heights that the program
/// refuses (recorded_range).
SceneTruth parallax_mapping_truth(const TruthRequest& request, const Settings& settings, std::optional<Scene> model);

/// The relief of a node with a mesh of make_plane, as the settings have it, in place of that mesh.
oracle::Shape relief_shape(const Scene& scene, const Node& node, const glm::dmat4& world, const Settings& settings);

/// The height of what is seen: linear in the distance along the view direction, 1 at range.x metres, 0 at range.y.
oracle::SurfaceColour height_in_view(const Camera& camera, const glm::dvec2& range);

}  // namespace atelier
