// gradebook.csv: a row per student, for spreadsheets and course platforms.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "grade/results/class_results.hpp"

namespace atelier::grade {

/// The columns that are written: course.columns, or by default student, id, a column for each step, total, late,
/// needs_human, report, and if anybody has written comments, adjustment and comment.
std::vector<GradebookColumn> gradebook_columns(const ClassResults& results);

/// UTF-8 (RFC 4180, lines end with \r\n): headings, then a row for each student, sorted by id. A student without a name
/// is named by the source. Points have at most two decimals and a point. A step that was not handed in is empty, unlike
/// one with 0 points. `late` and `needs_human` are "yes" or empty, the latter with the reasons.
std::string gradebook_csv(const ClassResults& results);

/// A stranger's text for a cell. Removes control and direction characters; line breaks and tabs become spaces. If a
/// spreadsheet would take the rest for a formula (it begins with = + - @, or with their wide forms, after any blanks),
/// a ' is put in front. (OWASP, "CSV Injection".)
std::string safe_cell(std::string_view text);

}  // namespace atelier::grade
