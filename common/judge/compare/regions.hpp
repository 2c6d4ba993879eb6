// Parts of a picture that a case does not compare, or that count more or less than others.
#pragma once

#include <glm/glm.hpp>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "image/compare.hpp"

namespace atelier::judge {

/// Pixels, from the upper left corner of the picture.
struct Rectangle {
  int x = 0, y = 0, width = 1, height = 1;
  bool operator==(const Rectangle&) const = default;
};

/// A part whose pixels count `weight` times where credit is given; all others count once.
struct Region {
  std::string name;  ///< what is seen there: "the highlight"; for who reads the case file, and for messages
  Rectangle at;
  double weight = 1;  ///< 0.01..100
  bool operator==(const Region&) const = default;
};

inline constexpr double largest_masked_share = 0.25;  ///< of a picture: more would leave too little to judge

/// [[x, y, width, height], ...], each inside a picture of `size`. Throws Error with `where`, the value and what is
/// allowed, also where the rectangles cover more than `largest_masked_share` of the picture.
std::vector<Rectangle> read_mask(const nlohmann::json& list, const std::string& where, glm::ivec2 size);

/// [{"name", "at": [x, y, width, height], "weight"}, ...], inside the picture and apart from each other. Throws as
/// read_mask() does.
std::vector<Region> read_regions(const nlohmann::json& list, const std::string& where, glm::ivec2 size);

/// What the two read.
nlohmann::json to_json(const std::vector<Rectangle>& mask);
nlohmann::json to_json(const std::vector<Region>& regions);

/// On where a picture of this size is masked.
Mask mask_of(const std::vector<Rectangle>& mask, glm::ivec2 size);

/// The share of the picture that `over` covers, 0..1: masked pixels left out, those of regions by their weights.
double weighted_share(const Mask& over, const std::vector<Rectangle>& mask, const std::vector<Region>& regions);

}  // namespace atelier::judge
