// The visible cases of a step, and their files.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "judge/compare/judged_case.hpp"

namespace atelier {

struct VisibleCases {
  std::string text;  ///< cases.json without hidden cases and without the member "hidden"
  std::vector<judge::JudgedCase> cases;
  std::set<std::filesystem::path> files;  ///< references, sidecars, atlases
  int hidden = 0;                         ///< number of hidden cases
  double hidden_points = 0;
};

/// Throws Error if the file is broken, a reference is missing, or every case is hidden.
VisibleCases visible_cases(const std::filesystem::path& case_file);

}  // namespace atelier
