// Places in the surface shader that features fill.
#pragma once

#include <string>

#include "gl/shader.hpp"

namespace atelier {

/// What a feature wants of the shader for one node: nothing, or a variant told by #defines. Numbers that change from
/// frame to frame are uniforms and stay out of it: they must not cost a compilation.
struct Need {
  bool wanted = false;
  Defines structure;
};

/// Places in the surface shader that features fill, in the order in which a fragment goes through them. Several
/// features may fill one; their code runs in the order of the renderer's list. Only `shade` has one owner: two that are
/// wanted for the same node are refused. Every function is GLSL; vectors are in world space.
enum class Slot {
  displace_texcoord,         ///< void f(inout Surface): moves surface.texcoord (parallax mapping)
  modify_surface,            ///< void f(inout Surface): anything else of the surface, above all its normal
  discard_fragment,          ///< bool f(Surface): whether there is nothing here
  visible_from_point,        ///< float f(int light, vec3 position, vec3 normal, vec3 to_light); see below
  visible_from_spot,         ///< the same
  visible_from_directional,  ///< the same
  shade,                     ///< vec3 f(Surface): the light that leaves the surface
  indirect,                  ///< vec3 f(Surface): light that is added to it
  modify_shaded,             ///< vec3 f(Surface, vec3 shaded): what becomes of it on the way to the eye (fog)
};
// What fills `visible_from_*` says which share, 0..1, of the light with this number (among those of its type) reaches
// the surface; 1 where it does not know. `normal` is of unit length or zero, `to_light` of unit length; for a
// directional light it is the way against its light. The answers of several features are multiplied. Code that fills
// `shade` may call the products, which are there where the define VISIBILITY is:
//   float visibility_of_point_light(int light, vec3 position, vec3 normal, vec3 to_light)
//   float visibility_of_spot_light(...), visibility_of_directional_light(...)

/// A piece of GLSL: the file that defines a function, and the function's name.
struct SlotCode {
  std::string include;   ///< "02-blinn-phong/given/surface_lighting.glsl"
  std::string function;  ///< "shade_surface"
};

}  // namespace atelier
