// Names of OpenGL's enums, for numbers that probes read back.
#pragma once

#include <string>

namespace atelier::judge {

/// "GL_LINEAR"; for a value without a name here the number as the header has it: "0x2601".
std::string gl_enum_name(double value);

}  // namespace atelier::judge
