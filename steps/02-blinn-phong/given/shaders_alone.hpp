// What the GLSL of step 02 needs where a later step's is tried alone: in probes, in tables of extremes. Given.
#pragma once

#include "gl/shader.hpp"

namespace atelier {

/// Defines for blinn_phong.glsl without lights.
inline Defines no_lights() {
  return {{"POINT_LIGHTS", "0"}, {"SPOT_LIGHTS", "0"}, {"DIRECTIONAL_LIGHTS", "0"}};
}

}  // namespace atelier
