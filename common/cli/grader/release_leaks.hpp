// A last look through what students get: no line of a solution may be in it.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "cli/layout.hpp"
#include "grade/zip.hpp"

namespace atelier {

/// Lines shorter than this say too little: `return false;` is in many a file.
inline constexpr std::size_t least_distinctive = 25;  ///< bytes, without the blanks round the line

/// What only the solutions of `steps` say: their lines (solution_lines) of at least least_distinctive bytes, but those
/// that the project gives everybody too: in common/, in the handouts, in the given files of any step, in a skeleton, or
/// in the solution of a step that is not among `steps`.
std::set<std::string> distinctive_lines(const ProjectFolders& folders, const std::vector<CourseStep>& course,
                                        const std::vector<CourseStep>& steps);

struct Leak {
  std::string file, line;
};

/// Every one of `lines` that stands in a text file (one without a null byte), in the order of the files.
std::vector<Leak> find_leaks(const grade::PackedFiles& files, const std::set<std::string>& lines);

}  // namespace atelier
