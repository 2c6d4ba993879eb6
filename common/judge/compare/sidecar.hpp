// The sidecar of a reference: how it was made, for which tolerance, and the distance of the nearest mistake.
//
// In tests/cases/NN-name/references/:
//   sphere.exr             the picture as the solution drew it: linear colour, or data
//   sphere.json            its sidecar
//   sphere.atlas.png       the pictures of known mistakes, encoded, at half size, one below the other in the order of
//                          the sidecar's "atlas"
//   look-at.values.json    of a probe: the sidecar, with the expected numbers unless the case file has them
//   look-at.mistakes.json  what known mistakes and the untouched skeleton return for a probe, and for a choice which
//                          limits they exceed
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

  // The case's tolerances when the reference was made; if they have changed, the reference is outdated.
  Profile profile = Profile::strict;
  Unit unit = Unit::colour;
  double delta = 3;
  int budget = 4;
  double exposure = 1;
  std::vector<Rectangle> mask;
  std::vector<Region> regions;
  std::string reason;

  std::string sha256;                              ///< of the picture file; empty for a probe
  std::map<std::string, std::string> environment;  ///< "driver", "cpu" ...: where it was made
  double skeleton_fraction = 1;        ///< f1: fraction of pixels (or inputs) that the untouched skeleton fails
  std::optional<std::string> nearest;  ///< the claimed mistake with the smallest margin
  double margin = 0;                   ///< its margin in tolerances; at least 2, or 0 if the case claims none
  std::vector<std::string> needs;      ///< the students' functions without any one of which the case fails
  std::vector<std::string> atlas;      ///< the mistakes in the atlas, from top to bottom

  std::vector<Numbers> values;  ///< of a probe whose expected numbers come from the reference; otherwise empty
};

/// Throws Error, naming the problem, if the file is not JSON or a member is unknown, missing or out of range.
Sidecar read_sidecar(const std::filesystem::path& file);
void write_sidecar(const std::filesystem::path& file, const Sidecar& sidecar);

/// Throws Error if `sidecar` was made for another case, or for other tolerances than `c` has now.
void check_sidecar(const Sidecar& sidecar, const JudgedCase& c, const std::filesystem::path& file);

/// Another spelling of a mistake may return other numbers than its patch: it is another form of the same mistake.
/// "gamma-twice~1" is the form of its first spelling.
inline std::string form_of_spelling(const std::string& mistake, std::size_t spelling) {
  return mistake + "~" + std::to_string(spelling + 1);
}
/// "gamma-twice" for all of its forms.
inline std::string mistake_of_form(const std::string& form) {
  return form.substr(0, form.find('~'));
}

/// Wrong answers to a probe.
struct WrongValues {
  /// By form, all forms of a mistake or none; empty: the probe does not see this form.
  std::map<std::string, std::vector<Numbers>> mistakes;
  std::vector<std::vector<Numbers>> unwritten;  ///< without the probe's function, alone and in the skeleton
};
WrongValues read_wrong_values(const std::filesystem::path& file);
void write_wrong_values(const std::filesystem::path& file, const WrongValues& values);

/// "sphere.json" beside "sphere.exr"; for a probe "look-at.values.json".
std::filesystem::path sidecar_path(const std::filesystem::path& picture);
std::filesystem::path values_path(const std::filesystem::path& folder, const std::string& case_name);
/// "sphere.atlas.png" and "look-at.mistakes.json".
std::filesystem::path atlas_path(const std::filesystem::path& folder, const std::string& case_name);
std::filesystem::path wrong_values_path(const std::filesystem::path& folder, const std::string& case_name);

/// "strict", "colour" ...: as in the case file.
std::string to_string(Profile profile);
std::string to_string(Unit unit);

}  // namespace atelier::judge
