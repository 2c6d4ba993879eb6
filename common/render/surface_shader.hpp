// Puts the surface shader together: the parts that every drawing has, and the GLSL of the features that are wanted.
#pragma once

#include <string>
#include <vector>

#include "gl/shader.hpp"
#include "render/feature.hpp"

namespace atelier {

/// What tells one program from another. Equal keys share a program.
struct SurfaceKey {
  std::vector<const Feature*> features;  ///< wanted ones, in the renderer's order
  Defines structure;                     ///< of all of them, plus TEXCOORDS, PER_VERTEX ...
  std::string output;
  bool has(const Feature& feature) const;
  bool operator<(const SurfaceKey& other) const;
};

/// The define of a SurfaceKey under which the shader writes magenta for a colour that is no number or infinite.
inline constexpr const char* marks_non_finite = "MARKS_NON_FINITE";

struct SurfaceSources {
  ShaderSource vertex, fragment;
};

/// What every driver has room for between the vertex and the fragment stage, in components.
inline constexpr int guaranteed_varyings = 60;

/// `transforms_glsl` is the include behind TransformFunctions::glsl, `varyings` how many components the driver has room
/// for: where the key asks for it, so many draw constants as fit beside the rest are handed over as varyings, unless
/// light is worked out at the corners. Throws Error for an output that neither the renderer nor a wanted feature
/// offers.
SurfaceSources assemble_surface(const FindFile& find, const std::string& transforms_glsl, const SurfaceKey& key,
                                int varyings = guaranteed_varyings);

/// What stands before the vertex stage of a pass (PassSources): attributes, matrices, and step 01's functions.
std::string pass_vertex_text(const std::string& transforms_glsl);

/// Intermediates that the renderer itself offers: "depth", "normal", "texcoord", "position".
std::vector<std::string> surface_outputs();

}  // namespace atelier
