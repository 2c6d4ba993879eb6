// class.html: one self-contained page about a class, for those who teach it.
#pragma once

#include <string>

#include "grade/results/class_results.hpp"

namespace atelier::grade {

inline constexpr std::size_t most_mistakes_shown = 12;  ///< with their pictures, which are bounded too

/// First what needs a person; then a table of all students that can be sorted and searched, a histogram of each step,
/// the mistakes made by most students, each with a picture if a student's folder has one
/// (grade/results/mistake_pictures.hpp), the slowest submissions, the sandbox, what was ignored, the environment. Loads
/// nothing; works without its script, but then neither sorts nor searches. All texts are escaped. Links lead to
/// students/ID/report.html.
std::string class_html(const ClassResults& results);

}  // namespace atelier::grade
