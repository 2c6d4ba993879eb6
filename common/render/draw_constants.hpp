// Constants of a draw: passed to the fragment stage as uniforms, or by the vertex stage as flat varyings. llvmpipe
// loads every uniform component again for every few pixels; flat varyings avoid that, but cost a little for every
// vertex and triangle, and their number is limited.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "gl/shader.hpp"

namespace atelier {

/// A uniform of a feature's GLSL that may be passed as a varying. It must be declared on its own line, `uniform TYPE
/// NAME;` or `uniform TYPE NAME[COUNT];`. Code that reads it does not change.
struct DrawConstant {
  struct Member {
    std::string type, name;  ///< the type must not be a struct
  };
  std::string type;                  ///< float, int, bool, vec2 to vec4, mat3, mat4; or a struct's name
  std::string name;                  ///< "u_ambient"
  std::string count = {};            ///< for an array: the define with its length; 0: it does not exist
  std::vector<Member> members = {};  ///< for a struct: all, in order
};

/// The define of a SurfaceKey that selects varyings for draw constants.
inline constexpr const char* constants_as_varyings = "CONSTANTS_AS_VARYINGS";

/// The constants that exist and fit into `available` components: in order, each only if it fits completely. Duplicates
/// are used once.
std::vector<DrawConstant> constants_that_fit(std::span<const DrawConstant> constants, const Defines& structure,
                                             int available);

/// GLSL that passes constants as varyings. They are packed into vec4s without gaps, as floats (exact for bools, and for
/// ints up to 2^24).
struct PassedConstants {
  /// A global variable that replaces a uniform.
  struct Global {
    std::string declared;  ///< the beginning of its declaration: "uniform vec3 u_ambient;", "uniform vec3 u_colours["
    std::string value;     ///< its initial value
  };
  std::string vertex_declarations, vertex_statements;  ///< uniforms and the output; statements that set it
  std::string fragment_declarations;                   ///< the input
  std::vector<Global> globals;                         ///< of the fragment stage
};

/// Empty without constants. Does not repeat declarations that are in `vertex_text`.
PassedConstants pass_as_varyings(std::span<const DrawConstant> constants, const Defines& structure,
                                 const std::string& vertex_text);

/// Replaces uniforms of the fragment stage by global variables that are initialised from the varyings: `uniform vec3
/// u_ambient;` becomes `vec3 u_ambient = ...;`. Throws Error if one is not declared as DrawConstant requires.
void make_global(ShaderSource& fragment, const PassedConstants& glsl);

}  // namespace atelier
