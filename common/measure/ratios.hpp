// Compares the frame times of two pictures that one program draws: a feature beside the same view without it, one way
// beside another. tests/cases/NN-name/ratios.json says which; tests/cases/README.md describes its members.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "measure/median.hpp"
#include "measure/program.hpp"

namespace atelier::measure {

/// Two pictures, and how much the first may cost.
struct RatioRow {
  std::string name;
  Case picture, beside;
  std::optional<Case> without;    ///< what both have in common: its time is subtracted from theirs
  std::optional<double> at_most;  ///< of the time of `beside`; none: the row is only reported
  std::optional<double> alike;    ///< the largest root mean square difference of the two; none: not compared
};

struct RatioPlan {
  std::vector<std::string> counts;  ///< those that are reported of both pictures, as --stats names them
  std::vector<RatioRow> rows;       ///< at least one
};

/// Parses a ratios.json; every error message begins with `where`. Throws Error naming the member and what is allowed.
RatioPlan parse_ratio_plan(std::string_view text, const std::string& where);
RatioPlan read_ratio_plan(const std::filesystem::path& file);  ///< the same, from a file

struct MeasuredRatio {
  /// Per frame: the median over the rounds of each round's median, without that of `without`.
  double seconds = 0, beside_seconds = 0;
  Spread ratio;                               ///< the time of the picture / that of `beside`, per round
  std::optional<double> difference;           ///< root mean square, if the row says that the pictures are alike
  std::vector<double> counts, beside_counts;  ///< parallel to the plan's
};

/// Whether the row costs no more than it may, and shows the same if it must.
bool holds(const RatioRow& row, const MeasuredRatio& measured);

/// In each round one process draws all pictures of a row, `frames` times each, and only their times are compared. So a
/// temporary slowdown of the machine affects all. Which of them is drawn first alternates. Throws Error if the program
/// has no such count, or if a picture takes no longer than what is subtracted from it.
std::vector<MeasuredRatio> measure_ratios(const RatioPlan& plan, const Program& program, int rounds, int frames);

}  // namespace atelier::measure
