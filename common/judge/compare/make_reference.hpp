// Making references: the solution's answer becomes what all others are measured by, if it can bear that.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "judge/compare/answer.hpp"
#include "judge/compare/judged_case.hpp"

namespace atelier::judge {

/// A claimed mistake must still fail when everything that the case tolerates is multiplied by this.
inline constexpr double least_margin = 2;

/// What was drawn for one case, and on what.
struct ReferenceMaterial {
  Answer solution;
  std::optional<Answer> truth{};                   ///< of a budget case: the oracle's picture, which is its reference
  std::optional<Answer> skeleton;                  ///< the untouched skeleton's; none: it is taken to fail everywhere
  std::map<std::string, Answer> mistakes;          ///< of every mistake of the step, claimed by this case or not
  std::map<std::string, std::string> environment;  ///< "driver", "cpu" ...
};

struct MadeReference {
  std::optional<std::string> nearest;     ///< the claimed mistake with the smallest margin
  double margin = 0;                      ///< its margin, in tolerances; 0 where the case claims none
  double skeleton_share = 1;              ///< what the skeleton fails, 0..1
  std::map<std::string, double> margins;  ///< of every mistake that answered; below 1: the case does not see it
  std::vector<std::filesystem::path> written;
};

/// Checks and writes the reference of `c` (its first one), its sidecar and its atlas into `folder`, NN-name/references;
/// an atlas that holds no mistake any more is removed. Writes nothing unless all is well. Throws Error naming the case
/// and
/// - what is wrong with the solution's answer: none, another size, values that are not finite, a single colour, and for
/// the
///   exact profile a value on the border between two 8-bit levels, which another processor would round the other way;
/// - the mistake that the case claims to catch and that passes, or lies within `least_margin` tolerances: both figures;
/// - a claimed mistake without an answer in `mistakes`, unless it crashed or ran out of time, which fails in any case;
/// - of a budget case, a truth that is missing, and a solution whose own choice does not earn all points;
/// - an untouched skeleton that passes a case which a student is meant to earn.
MadeReference make_reference(const std::filesystem::path& folder, const JudgedCase& c,
                             const ReferenceMaterial& material);

/// The checks alone; `written` stays empty.
MadeReference check_reference(const JudgedCase& c, const ReferenceMaterial& material);

}  // namespace atelier::judge
