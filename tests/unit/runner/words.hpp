// The words that a message must have, kept in the rows of a table.
#pragma once

#include <string>
#include <string_view>
#include <vector>

/// A row must own its words: the array behind an initializer_list is gone when the table stands.
using Words = std::vector<std::string>;

inline bool has_all(std::string_view text, const Words& words) {
  for (const std::string& word : words)
    if (text.find(word) == std::string_view::npos) return false;
  return true;
}
