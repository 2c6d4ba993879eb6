// Hints in three levels: a first pointer, the idea, almost the answer.
//
// Level 1 is the case's own hint (cases.json). Levels 2 and 3 belong to functions, and are used for every case that
// names the function: tests/cases/NN-name/hints.json, beside the cases.
//
//   {"schema": 1, "step": "02-blinn-phong",
//    "functions": {"srgb_encode": ["level 2: the idea or formula, and where the handout has it",
//                                  "level 3: nearly the answer, in words; never the solution's lines"], ...}}
//
// Every function that a case names must have both, and no other functions are allowed. Each text is one line of at most
// 1000 bytes.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "cli/layout.hpp"
#include "cli/student/contract.hpp"
#include "cli/student/progress_record.hpp"
#include "judge/compare/judged_case.hpp"

namespace atelier {

/// Levels 2 and 3 by function.
using FunctionHints = std::map<std::string, std::array<std::string, 2>>;

/// Reads hints.json and checks it against the cases. Throws Error naming file, member, value and what is allowed, also
/// for a missing function and for one that no case names.
FunctionHints read_hints(const std::filesystem::path& file, const judge::CaseFile& cases);

inline constexpr std::size_t most_contracts = 2;  ///< more would hide the hint

/// One hint, as it is shown.
struct Hint {
  std::string step, case_name, case_title;
  int level = 1, levels = most_hints;  ///< "hint 2 of 3"; a case that names no function has one level only
  std::vector<std::string> functions;  ///< the function of each of `texts`; empty at level 1
  std::vector<std::string> texts;
  std::vector<Contract> contracts;  ///< at level 1: of the functions in question, if at most most_contracts
};

/// The hint of `level` (1..3, clamped to the existing levels) for a case. If `case_name` is empty, the case is the
/// first in the case file that the last full check did not pass, or the very first without a check. Functions whose own
/// cases (which name no other function) have all passed are left out, unless none would be left. Throws Error for an
/// unknown case, and if no case is named and all have passed.
Hint hint_at(const ProjectFolders& folders, const CourseStep& step, const std::string& case_name,
             const ProgressRecord& record, int level);

/// The next hint for a case (as above): one level above the last shown one, at most the last level. Stores the level in
/// `record`, which the caller must write (write_progress).
Hint next_hint(const ProjectFolders& folders, const CourseStep& step, const std::string& case_name,
               ProgressRecord& record);

/// The hint for a terminal: the case, "hint 2 of 3", the contracts, the texts in lines of at most `width` columns, and
/// the command for the next.
std::string hint_text(const Hint& hint, int width);

}  // namespace atelier
