// Finds a function in a C++ or GLSL file without compiling it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace atelier {

struct FunctionText {
  int line = 1;      ///< where it begins, from 1
  std::string text;  ///< whole lines, from its return type to the closing brace
};

/// The first definition of `name`: NAME(...) {...}, finds the parameters and the body by their brackets. Ignores
/// comments, strings and characters. None if there is none, or a bracket is not closed.
std::optional<FunctionText> find_function(std::string_view text, std::string_view name);

/// Whether two texts differ only in comments and white space.
bool same_code(std::string_view a, std::string_view b);

/// The contract of `name`: the comment lines (//) directly above its first declaration or definition, and its head up
/// to the ';' or '{', exclusive. None if there is no such function, or no comment above it.
std::optional<FunctionText> find_contract(std::string_view text, std::string_view name);

}  // namespace atelier
