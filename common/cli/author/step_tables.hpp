// The tables of all steps in README.md and handouts/README.md: their rows follow from what each step says of itself.
//
// Titles are those of step.cmake, points those of the cases, hours those of the handout's own table. The words are in
// docs/steps/NN-name.json:
//   {"picture": "what docs/pictures/NN-name.png shows", "sentence": "for README.md", "topics": "for
//   handouts/README.md",
//    "hours": "½"}    (hours only where the handout has no table of tiers)
// Steps that are only planned stand in docs/steps/planned.json, a list of {"step", "sentence"}; one whose number there
// is by now is passed over.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cli/layout.hpp"

namespace atelier {

/// The rows of README.md. Throws Error naming file and member where a step's words are missing.
std::string rows_of_readme(const ProjectFolders& folders, const std::vector<CourseStep>& course);

/// The rows of handouts/README.md. Throws likewise.
std::string rows_of_handouts(const ProjectFolders& folders, const std::vector<CourseStep>& course);

inline constexpr std::string_view table_begins = "<!-- rows by ./atelier tables -->\n";
inline constexpr std::string_view table_ends = "<!-- end of rows -->\n";

/// The text with other rows in the table between these two lines; the table's first two lines stay. Throws Error naming
/// `file` where the lines are not there, once and in this order, or no table is between them.
std::string with_rows(const std::string& text, const std::string& rows, const std::string& file);

}  // namespace atelier
