// What stands beside a reference: how it was made, for which tolerance, and how far the nearest mistake is.
//
//   tests/cases/NN-name/references/sphere.exr             the picture as the solution drew it: linear colour, or data
//   tests/cases/NN-name/references/sphere.json            its sidecar
//   tests/cases/NN-name/references/sphere.atlas.png       what known mistakes draw, encoded, at half size, one below
//   the
//                                                         other in the order of the sidecar's "atlas"
//   tests/cases/NN-name/references/look-at.values.json    of a probe: the sidecar, with the numbers where they were
//   made tests/cases/NN-name/references/look-at.mistakes.json  what known mistakes answer to a probe
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "judge/compare/judged_case.hpp"

namespace atelier::judge {

struct Sidecar {
  std::string case_name;

  // What the margin below was measured against: a reference is stale once its case says otherwise.
  Profile profile = Profile::strict;
  Unit unit = Unit::colour;
  double delta = 3;
  int budget = 4;
  double exposure = 1;
  std::vector<Rectangle> mask;
  std::vector<Region> regions;
  std::string reason;

  std::string sha256;                              ///< of the picture file; empty for a probe
  std::map<std::string, std::string> environment;  ///< "driver", "cpu" ...: what it was made on
  double skeleton_share = 1;           ///< f1: share of pixels (or inputs) that the untouched skeleton fails
  std::optional<std::string> nearest;  ///< the claimed mistake that lies nearest, and
  double margin = 0;                   ///< how many tolerances away it still fails; at least 2
  std::vector<std::string> atlas;      ///< the mistakes whose pictures the atlas holds, from top to bottom

  std::vector<Numbers> values;  ///< of a probe whose case file leaves them to the reference; else empty
};

/// Both name what they refuse: not JSON, a member unknown, missing or out of range. Throw Error.
Sidecar read_sidecar(const std::filesystem::path& file);
void write_sidecar(const std::filesystem::path& file, const Sidecar& sidecar);

/// Throws Error where `sidecar` was made for another case, or for other tolerances than `c` has now.
void check_sidecar(const Sidecar& sidecar, const JudgedCase& c, const std::filesystem::path& file);

/// What known mistakes answer to a probe, by the mistake's name.
using WrongValues = std::map<std::string, std::vector<Numbers>>;
WrongValues read_wrong_values(const std::filesystem::path& file);
void write_wrong_values(const std::filesystem::path& file, const WrongValues& values);

/// "sphere.json" beside "sphere.exr"; for a probe "look-at.values.json".
std::filesystem::path sidecar_path(const std::filesystem::path& picture);
std::filesystem::path values_path(const std::filesystem::path& folder, const std::string& case_name);
/// "sphere.atlas.png" and "look-at.mistakes.json".
std::filesystem::path atlas_path(const std::filesystem::path& folder, const std::string& case_name);
std::filesystem::path wrong_values_path(const std::filesystem::path& folder, const std::string& case_name);

/// "strict", "colour" ...: the words of the case file.
std::string to_string(Profile profile);
std::string to_string(Unit unit);

}  // namespace atelier::judge
