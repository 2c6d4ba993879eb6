// Assembles the surface shader: the common parts, and the GLSL of the features that are needed.
#pragma once

#include <string>
#include <vector>

#include "gl/shader.hpp"
#include "render/feature.hpp"

namespace atelier {

/// The cache key of a program. Equal keys share a program.
struct SurfaceKey {
  std::vector<const Feature*> features;  ///< the needed ones, in the renderer's order
  Defines structure;                     ///< of all of them, plus TEXCOORDS, PER_VERTEX ...
  std::string output;
  bool has(const Feature& feature) const;
  bool operator<(const SurfaceKey& other) const;
};

/// The define of a SurfaceKey that makes the shader write magenta for a NaN or infinite colour.
inline constexpr const char* marks_non_finite = "MARKS_NON_FINITE";

struct SurfaceSources {
  ShaderSource vertex, fragment;
};

/// The number of varying components that every driver supports.
inline constexpr int guaranteed_varyings = 60;

/// `transforms_glsl` is TransformFunctions::glsl, `varyings` the driver's limit of varying components: if the key
/// selects it, as many draw constants as fit are passed as varyings, except with per-vertex lighting. Throws Error for
/// an output that neither the renderer nor a needed feature offers.
SurfaceSources assemble_surface(const FindFile& find, const std::string& transforms_glsl, const SurfaceKey& key,
                                int varyings = guaranteed_varyings);

/// The beginning of a pass's vertex stage (PassSources): attributes, matrices, and step 01's functions.
std::string pass_vertex_text(const std::string& transforms_glsl);

/// The renderer's own intermediate results: "depth", "normal", "texcoord", "position".
std::vector<std::string> surface_outputs();

}  // namespace atelier
