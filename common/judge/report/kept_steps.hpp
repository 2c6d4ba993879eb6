// Steps that stay as an earlier report of the same submission has them, where only others are graded again.
#pragma once

#include <filesystem>
#include <vector>

#include "judge/compare/result.hpp"

namespace atelier::judge {

/// The steps of FOLDER/results.json and FOLDER/report.html that are not in `graded`, in the order of the file. Where
/// there is no earlier report, or one of another version, none.
std::vector<StepResult> kept_steps(const std::filesystem::path& folder, const std::vector<StepResult>& graded);

/// Encloses the part of a step in a report, so that it can be found again: strangers' text has no such marks, since all
/// of it is escaped.
std::string marked_section(const std::string& step, const std::string& html);

}  // namespace atelier::judge
