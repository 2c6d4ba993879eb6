// A row about a NaN in one pixel of many.
#pragma once

#include <string>

#include "stability/shader_function.hpp"
#include "stability/table.hpp"

namespace atelier::stability {

/// A row: the same call in 64 pixels, one of which has a NaN as its first argument instead. The others come out as they
/// do without it. `words` stand in front of its text.
void add_nan_row(Group& group, ShaderFunctions& shaders, const ShaderFunction& function, const ShaderInput& call,
                 const std::string& words = "");

}  // namespace atelier::stability
