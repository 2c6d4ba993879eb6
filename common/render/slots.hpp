// Slots: the places in the surface shader that features fill.
#pragma once

#include <string>

#include "gl/shader.hpp"

namespace atelier {

/// What a feature needs in the shader of one node: nothing, or a variant given by #defines. Numbers that change from
/// frame to frame are uniforms instead, to avoid recompilation.
struct Need {
  bool wanted = false;
  Defines structure;
};

/// Slots, in the order in which they run for a fragment. Several features may fill one; their code runs in the order of
/// the renderer's list. Only `shade` has a single owner: two for the same node are an error. Every function is GLSL;
/// vectors are in world space.
enum class Slot {
  displace_texcoord,         ///< void f(inout Surface): moves surface.texcoord (parallax mapping)
  modify_surface,            ///< void f(inout Surface): changes other members, mainly the normal
  discard_fragment,          ///< bool f(Surface): whether to discard the fragment
  visible_from_point,        ///< float f(int light, vec3 position, vec3 normal, vec3 to_light); see below
  visible_from_spot,         ///< the same
  visible_from_directional,  ///< the same
  shade,                     ///< vec3 f(Surface): the reflected and emitted light
  indirect,                  ///< vec3 f(Surface): light to add
  modify_shaded,             ///< vec3 f(Surface, vec3 shaded): changes the light on the way to the eye (fog)
};
// `visible_from_*` returns the fraction, 0..1, of a light that reaches the surface; 1 if unknown. `light` is the index
// among the lights of its type. `normal` is of unit length or zero, `to_light` of unit length; for a directional light
// it is opposite to the light's direction. The results of several features are multiplied. Code in `shade` may call the
// products, which exist if VISIBILITY is defined:
//   float visibility_of_point_light(int light, vec3 position, vec3 normal, vec3 to_light)
//   float visibility_of_spot_light(...), visibility_of_directional_light(...)

/// A GLSL function: the file that defines it, and its name.
struct SlotCode {
  std::string include;   ///< "02-blinn-phong/given/surface_lighting.glsl"
  std::string function;  ///< "shade_surface"
};

}  // namespace atelier
