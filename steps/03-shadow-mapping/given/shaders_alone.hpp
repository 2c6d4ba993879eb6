// What the GLSL of step 03 needs where it, or a later step's, is tried alone: in probes, in tables of extremes. Given.
#pragma once

#include <string>

#include "02-blinn-phong/given/shaders_alone.hpp"

namespace atelier {

/// Defines for shadow_mapping.glsl without lights, and without lights that have a map.
inline Defines no_shadow_lights() {
  Defines defines = no_lights();
  defines.emplace("SHADOW_LIGHTS", "0");
  return defines;
}

/// Stands before shadow_mapping.glsl and leaves it to a probe's arguments to declare u_bias and u_depth_epsilon:
/// shadows.glsl declares others in their place.
inline const std::string bias_as_argument =
    text_including("03-shadow-mapping/given/shadows.glsl",
                   {{"u_bias", "u_other_bias"}, {"u_depth_epsilon", "u_other_depth_epsilon"}}) +
    "#undef u_bias\n#undef u_depth_epsilon\n";

}  // namespace atelier
