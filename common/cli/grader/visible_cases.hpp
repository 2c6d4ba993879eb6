// The cases of a step that students may see, and the files that belong to them.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "judge/compare/judged_case.hpp"

namespace atelier {

struct VisibleCases {
  std::string text;  ///< cases.json without the hidden cases and without the word
  std::vector<judge::JudgedCase> cases;
  std::set<std::filesystem::path> files;  ///< references, sidecars, atlases
  int hidden = 0;                         ///< how many there are
  double hidden_points = 0;
};

/// Throws Error where the file is broken, where a reference is missing, and where every case is hidden.
VisibleCases visible_cases(const std::filesystem::path& case_file);

}  // namespace atelier
