// What has one value for all of a draw, and how it comes to the fragment stage: as a uniform, or through the vertex
// stage as a varying that does not vary. llvmpipe fetches each number of a uniform anew for every few pixels, which a
// flat varying spares it; but each costs a little for every corner and triangle, and a driver has room for few.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "gl/shader.hpp"

namespace atelier {

/// A uniform of a feature's GLSL that may be handed over as a varying. It is declared there in a line of its own,
/// `uniform TYPE NAME;` or `uniform TYPE NAME[COUNT];`, and stays what it is for all code that reads it.
struct DrawConstant {
  struct Member {
    std::string type, name;  ///< of a type that has a number of components
  };
  std::string type;                  ///< float, int, bool, vec2 to vec4, mat3, mat4; or a struct's name
  std::string name;                  ///< "u_ambient"
  std::string count = {};            ///< of an array: the define that is its length; 0: there is none
  std::vector<Member> members = {};  ///< of a struct: all, in their order
};

/// The define of a SurfaceKey under which draw constants are handed over as varyings.
inline constexpr const char* constants_as_varyings = "CONSTANTS_AS_VARYINGS";

/// Those that exist and fit into `room` components: each in its turn, if there is room left for all of it. What is
/// listed twice is taken once.
std::vector<DrawConstant> constants_that_fit(std::span<const DrawConstant> constants, const Defines& structure,
                                             int room);

/// GLSL that hands constants over. They are packed into vec4s without gaps, as floats (exact for bools, and for ints
/// up to 2^24).
struct HandingOver {
  /// What is a uniform without this.
  struct Global {
    std::string declared;  ///< how its declaration begins: "uniform vec3 u_ambient;", "uniform vec3 u_colours["
    std::string value;     ///< what it is set to
  };
  std::string vertex_declarations, vertex_statements;  ///< uniforms and the output; what sets it
  std::string fragment_declarations;                   ///< the input
  std::vector<Global> globals;                         ///< of the fragment stage
};

/// Nothing at all for no constants. What `vertex_text` declares already is not declared again.
HandingOver hand_over(std::span<const DrawConstant> constants, const Defines& structure,
                      const std::string& vertex_text);

/// Turns the uniforms of the fragment stage into global variables that are set to what has been handed over, each in
/// the line that declares it: `uniform vec3 u_ambient;` becomes `vec3 u_ambient = ...;`. Throws Error where one is not
/// declared as DrawConstant says.
void make_global(ShaderSource& fragment, const HandingOver& glsl);

}  // namespace atelier
