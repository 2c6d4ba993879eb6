// Names of OpenGL's enums, for numbers that probes read back and for arguments of calls.
#pragma once

#include <string>

namespace atelier {

/// "GL_LINEAR"; for a value without a name here the number as the header has it: "0x2601". Values below 0x100 mean
/// different things in different calls, and only 0 has a name: "GL_NONE". No whole number of 16 bits: as a number.
std::string gl_enum_name(double value);

}  // namespace atelier
