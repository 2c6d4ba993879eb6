// The table of all students in class.html.
#pragma once

#include <string>

#include "grade/results/class_statistics.hpp"

namespace atelier::grade {

/// A row per student, with what the script needs to sort and search it: `data-value` holds a cell's number, and cells
/// without one are sorted last.
std::string class_table_html(const ClassResults& results, const ClassStatistics& statistics);

/// A link to a student's report: the name, without one the source.
std::string student_link(const ClassRow& row);

/// "7 students"
std::string students_words(std::size_t number);

}  // namespace atelier::grade
