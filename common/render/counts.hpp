// The renderer's counts for a frame, beside those of OpenGL calls.
#pragma once

#include <cstdint>

namespace atelier {

/// For one frame. GlCounts has the counts of OpenGL calls.
struct SceneCounts {
  std::int64_t views = 0;          ///< in which surfaces are drawn: the frame's, and those inside it
  std::int64_t view_pixels = 0;    ///< of their rectangles: the target, or the scissor in it
  std::int64_t nodes = 0;          ///< with a mesh, in all views together
  std::int64_t nodes_culled = 0;   ///< of those, skipped because they are outside the view
  std::int64_t skies = 0;          ///< draws of the sky: one for each view of colour, if the scene has a sky
  std::int64_t matrices = 0;       ///< world and normal matrices computed
  std::int64_t lights = 0;         ///< summed by the shaders for each point
  std::int64_t lookups = 0;        ///< texels of shadow maps and height maps read for each point
  std::int64_t lights_culled = 0;  ///< of the scene's others, skipped because they are too weak to be visible
};

}  // namespace atelier
