// Parts of a picture that a case does not compare (masks) or weights differently (regions).
#pragma once

#include <glm/glm.hpp>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "image/compare.hpp"

namespace atelier::judge {

/// In pixels from the upper left corner of the picture.
struct Rectangle {
  int x = 0, y = 0, width = 1, height = 1;
  bool operator==(const Rectangle&) const = default;
};

/// A part whose pixels count `weight` times for partial credit; all others count once.
struct Region {
  std::string name;  ///< what it shows: "the highlight"; for readers of the case file and for messages
  Rectangle at;
  double weight = 1;  ///< 0.01..100
  bool operator==(const Region&) const = default;
};

inline constexpr double max_masked_fraction = 0.25;  ///< of a picture; a larger mask would leave too little to judge

/// Reads [[x, y, width, height], ...], each inside a picture of `size`. Throws Error with `where`, the value and what
/// is allowed, also if the rectangles cover more than `max_masked_fraction` of the picture.
std::vector<Rectangle> read_mask(const nlohmann::json& list, const std::string& where, glm::ivec2 size);

/// Reads [{"name", "at": [x, y, width, height], "weight"}, ...], inside the picture and without overlap. Throws as
/// read_mask() does.
std::vector<Region> read_regions(const nlohmann::json& list, const std::string& where, glm::ivec2 size);

/// The JSON that read_mask() and read_regions() read.
nlohmann::json to_json(const std::vector<Rectangle>& mask);
nlohmann::json to_json(const std::vector<Region>& regions);

/// A mask for a picture of this size: set in the rectangles.
Mask mask_of(const std::vector<Rectangle>& mask, glm::ivec2 size);

/// The fraction of the picture that `over` covers, 0..1, without masked pixels and with the weights of regions.
double weighted_fraction(const Mask& over, const std::vector<Rectangle>& mask, const std::vector<Region>& regions);

}  // namespace atelier::judge
