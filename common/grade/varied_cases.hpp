// The cases of a step with numbers drawn for one submission, beside what the solution answers to them here.
//
// A stored reference can be handed in: as a picture, or as a table of the expected numbers. The answers to these cases
// do not exist before somebody grades.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "judge/compare/answer.hpp"
#include "judge/compare/judged_case.hpp"
#include "judge/compare/references.hpp"
#include "judge/compare/result.hpp"
#include "judge/run/runner.hpp"

namespace atelier::grade {

/// Largest seed: every JSON reader keeps it exactly.
inline constexpr std::uint64_t max_seed = (std::uint64_t(1) << 53) - 1;

/// One case with drawn numbers.
struct VariedCase {
  judge::JudgedCase judged;  ///< under judge::name_of_varied
  std::size_t of = 0;        ///< index of the stored case that it varies
  std::string numbers;       ///< what was drawn, in words
};

struct VariedCases {
  std::uint64_t seed = 0;
  std::vector<VariedCase> cases;     ///< sorted by `of`
  judge::StepReferences references;  ///< of these cases: no known mistakes, since an atlas shows other numbers
};

/// The solution's answer as the reference of a case; nothing if it is no whole answer.
std::optional<judge::CaseReferences> as_references(const judge::JudgedCase& c, judge::Answer answer);

/// Those of `cases` that say what may vary, with numbers drawn by `seed` (judge/compare/variation.hpp).
std::vector<VariedCase> draw_numbers(const std::vector<judge::JudgedCase>& cases, std::uint64_t seed);

/// Draws numbers for `cases` and has the solution answer them; `solution` must use the same driver as the submission
/// will. `stored` are the references of `cases`, for the partial credit. Throws Error naming the case that the solution
/// does not answer.
VariedCases vary_cases(const std::vector<judge::JudgedCase>& cases, const judge::StepReferences& stored,
                       std::uint64_t seed, const judge::RunSettings& solution);

/// Joins the verdicts on a case with the stored numbers and on the same case with drawn ones: it passes only if both
/// do. If only the drawn ones fail, theirs is the verdict, and its reason begins with the numbers.
judge::CaseResult both(judge::CaseResult stored, judge::CaseResult varied, const std::string& numbers);

}  // namespace atelier::grade
