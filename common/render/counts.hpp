// What a renderer has done for a frame beyond calling OpenGL.
#pragma once

#include <cstdint>

namespace atelier {

/// Of one frame. What OpenGL was asked for stands in GlCounts.
struct SceneCounts {
  std::int64_t nodes = 0;          ///< with a mesh: what there is to draw, in all views together
  std::int64_t nodes_culled = 0;   ///< of those, left out because they are outside the view
  std::int64_t matrices = 0;       ///< world and normal matrices computed
  std::int64_t lights = 0;         ///< that the shaders add up for each point
  std::int64_t lookups = 0;        ///< of texels of shadow maps, for each point, in the maps of all lights
  std::int64_t lights_culled = 0;  ///< of the scene's others, left out because they cannot be seen to matter
};

}  // namespace atelier
