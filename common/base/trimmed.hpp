// Text without the blanks around it.
#pragma once

#include <string_view>

namespace atelier {

/// Without spaces, tabs and carriage returns at both ends.
inline std::string_view trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t\r");
  if (begin == text.npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

}  // namespace atelier
