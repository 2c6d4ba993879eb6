// Changes of a text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace atelier {

struct Edit {
  std::size_t begin = 0, end = 0;  ///< what it replaces
  std::string text;                ///< the replacement
  std::string kind;                ///< "operator", "constant", "call" ...
};

/// The text with these edits, which must not overlap.
std::string edited(std::string_view text, std::vector<Edit> edits);

/// As many edits as possible, at most `count`, that do not overlap: a random sample that depends on `seed` alone.
std::vector<Edit> sampled(std::vector<Edit> edits, std::size_t count, std::uint64_t seed);

}  // namespace atelier
