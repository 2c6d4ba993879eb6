// Characters and lines of C++ and GLSL.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace atelier {

/// Whether a character may stand in an identifier.
inline bool in_identifier(char c) {
  return c == '_' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// Where the line begins that position `at` is in.
inline std::size_t begin_of_line(std::string_view text, std::size_t at) {
  const std::size_t before = at == 0 ? text.npos : text.rfind('\n', at - 1);
  return before == text.npos ? 0 : before + 1;
}

/// The number of the line that position `at` is in, from 1.
inline int line_number(std::string_view text, std::size_t at) {
  return int(std::count(text.begin(), text.begin() + std::ptrdiff_t(at), '\n')) + 1;
}

}  // namespace atelier
