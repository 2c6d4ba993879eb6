// An output of a step program: the picture, or an intermediate result that it can draw in the picture's place.
#pragma once

#include <string>
#include <string_view>

#include "image/colour.hpp"

namespace atelier {

/// Where an output is computed. The first five are in the order of the pipeline.
enum class Stage {
  surface,       ///< of the visible surface: position, depth, texture coordinate, normal
  light,         ///< what arrives at the surface, and what it reflects: shadow factor, diffuse, specular
  pass,          ///< the picture after a pass of the chain
  colour,        ///< the picture
  after_colour,  ///< made from the picture: encoded, edges
  aside,         ///< made from the surface, but no part of the picture: a recorded normal map
  other_view,    ///< seen from elsewhere, so that its pixels are not those of the picture: a shadow map
};

std::string to_string(Stage stage);  ///< "surface", "after_colour" ...: as --list --json prints it

/// Throws Error naming the stages if there is none of this name.
Stage stage_named(std::string_view name);

struct OutputSpec {
  std::string name;                      ///< "colour", "depth", ...
  Encoding encoding = Encoding::linear;  ///< linear colour, sRGB-encoded colour, or data (a depth, a coded direction)
  std::string help;                      ///< one sentence with the unit
  Stage stage = Stage::light;            ///< outputs of one stage are listed in the order of the pipeline
};

}  // namespace atelier
