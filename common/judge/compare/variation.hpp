// The numbers of a case that are drawn anew for every submission: a table of stored answers then passes no longer.
//
// The member "vary" of a case gives a range for each of them. In a picture:
//
//   "vary": {"camera": {"eye": [[0, 1, 4], [1, 2, 5]], "fov_y_degrees": [40, 50]},
//            "settings": {"grazing.angle": [55.0, 65.0], "shadow.fit": ["cone", "casters"]},
//            "size": [[250, 240], [240, 250]]}
//
// and in a probe, which is then asked for `count` further inputs:
//
//   "vary": {"count": 4, "like": [0, 2], "inputs": {"normal": [-1, 1], "exponent": [2.0, 40.0]}, "unit": ["normal"]}
//
// A range is [low, high], inclusive. Two whole numbers stand for the whole numbers between them. Otherwise multiples of
// a power of two are drawn, at most a thousandth of the range apart: a float holds each of them exactly.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "case/case.hpp"

namespace atelier::judge {

/// One number, or several, between `low` and `high`, component by component. Of one component: each number of what it
/// is drawn for is drawn from it.
struct NumberRange {
  Numbers low, high;  ///< of equal length, low <= high
  bool whole = false;
};

/// A setting: one of these values, or a value between these two.
struct SettingRange {
  std::vector<SettingValue> choices;  ///< empty: a number or a colour from `range`
  NumberRange range;
};

/// What is drawn for a case; empty members are kept as the case has them.
struct Variation {
  // Of a picture
  std::map<std::string, NumberRange> camera;     ///< by member of the camera
  std::map<std::string, SettingRange> settings;  ///< by setting; also of a probe
  std::vector<glm::ivec2> sizes;                 ///< one of these

  // Of a probe
  int count = 0;                              ///< inputs
  std::vector<std::size_t> like;              ///< the case's inputs that they begin as, in turn
  std::map<std::string, NumberRange> inputs;  ///< by member of the input
  std::vector<std::string> unit;              ///< members that are scaled to length 1 when they are drawn
};

/// Reads the member "vary" of the case `ask`. Throws Error naming the member, the value and what is allowed: for a
/// range whose low end is above the high one, a range of another length than what it is drawn for, a member that an
/// input lacks, a case whose name is too long for a second one (name_of_varied), or nothing to draw.
Variation read_variation(const nlohmann::json& object, const Case& ask, const std::string& where);

/// A case with drawn numbers.
struct Varied {
  Case ask;             ///< under name_of_varied
  std::string numbers;  ///< what was drawn, in words: "camera.eye = (0.5, 1.25, 4), size = 250x240"
};

/// Depends on `seed`, the case's name and the ranges alone, and is the same on every machine. Cases do not depend on
/// one another.
Varied vary(const Case& ask, const Variation& variation, std::uint64_t seed);

/// "NAME-varied".
std::string name_of_varied(const std::string& name);

}  // namespace atelier::judge
