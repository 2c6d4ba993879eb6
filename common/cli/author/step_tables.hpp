// Generates the rows of the step tables in README.md and handouts/README.md.
//
// Titles come from step.cmake, points from the cases, hours from the handout's table. The texts are in
// docs/steps/NN-name.json:
//   {"picture": "what docs/pictures/NN-name.png shows", "sentence": "for README.md", "topics": "for
//   handouts/README.md",
//    "hours": "½"}    (hours only where the handout has no table of tiers)
// Planned steps are in docs/steps/planned.json, a list of {"step", "sentence"}; entries of existing steps are ignored.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cli/layout.hpp"

namespace atelier {

/// The rows of README.md. Throws Error naming file and member if a step's texts are missing.
std::string rows_of_readme(const ProjectFolders& folders, const std::vector<CourseStep>& course);

/// The rows of handouts/README.md. Throws likewise.
std::string rows_of_handouts(const ProjectFolders& folders, const std::vector<CourseStep>& course);

inline constexpr std::string_view table_begins = "<!-- rows by ./atelier tables -->\n";
inline constexpr std::string_view table_ends = "<!-- end of rows -->\n";

/// Replaces the rows of the table between these two lines; the table's first two lines stay. Throws Error naming `file`
/// unless both lines occur once, in this order, with a table between them.
std::string with_rows(const std::string& text, const std::string& rows, const std::string& file);

}  // namespace atelier
