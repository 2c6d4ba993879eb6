// What a course.toml means, in words and a table, for ./atelier course check.
#pragma once

#include <map>
#include <string>

#include "grade/course/course_file.hpp"

namespace atelier::grade {

/// Plain text of some lines. `steps` are those of the project, by name with their titles. Settings that have no effect
/// are named at the end.
std::string course_in_words(const CourseFile& course, const std::map<std::string, std::string>& steps);

}  // namespace atelier::grade
