// Makes references: the solution's answer becomes the reference if it passes all checks.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "judge/compare/answer.hpp"
#include "judge/compare/judged_case.hpp"

namespace atelier::judge {

/// A claimed mistake must still fail if all tolerances of the case are multiplied by this factor.
inline constexpr double min_margin = 2;

/// All answers to one case, and the environment that they were drawn in.
struct ReferenceMaterial {
  Answer solution;
  std::optional<Answer> truth{};           ///< of a budget case: the oracle's picture, which is its reference
  std::optional<Answer> skeleton;          ///< the untouched skeleton's; none: assumed to fail everywhere
  std::map<std::string, Answer> mistakes;  ///< of every mistake of the step, claimed by this case or not
  std::map<std::string, std::vector<Answer>> spellings;  ///< by mistake: of its other spellings, to a probe
  std::map<std::string, Answer> without;  ///< by function: of the solution with this function as in the skeleton
  std::map<std::string, std::string> environment;  ///< "driver", "cpu" ...
};

struct MadeReference {
  std::optional<std::string> nearest;     ///< the claimed mistake with the smallest margin
  double margin = 0;                      ///< its margin, in tolerances; 0 if the case claims none
  double skeleton_fraction = 1;           ///< the fraction that the skeleton fails, 0..1
  std::map<std::string, double> margins;  ///< by mistake, for all in `mistakes`; below 1: the case does not detect it
  std::vector<std::filesystem::path> written;
};

/// Checks the reference of `c` (its first one) and writes it, its sidecar and its atlas into `folder`,
/// NN-name/references; removes an atlas that has become empty. Writes nothing if a check fails. Throws Error naming the
/// case and
/// - the problem with the solution's answer: none, wrong size, values that are not finite, a single colour, or for the
///   exact profile a value halfway between two 8-bit levels, whose rounding depends on the processor;
/// - a claimed mistake that passes or is less than `min_margin` tolerances away;
/// - a claimed mistake without an answer in `mistakes`, unless it crashed or timed out, which always fails;
/// - for a budget case, a missing truth, or a solution whose choice does not earn all points;
/// - an untouched skeleton that passes although `c.student` is set and the case has points, or whose choice earns
///   points.
MadeReference make_reference(const std::filesystem::path& folder, const JudgedCase& c,
                             const ReferenceMaterial& material);

/// Only the checks; `written` stays empty.
MadeReference check_reference(const JudgedCase& c, const ReferenceMaterial& material);

}  // namespace atelier::judge
