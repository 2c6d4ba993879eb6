// Checks that a release contains no line of a solution.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "cli/layout.hpp"
#include "grade/zip.hpp"

namespace atelier {

/// Shorter lines, such as `return false;`, are not distinctive.
inline constexpr std::size_t min_line_length = 25;  ///< bytes, without the surrounding blanks

/// Whether a given file computes what students must find out, in another way: the truth (*truth.cpp), an exact or a
/// fast method to compare with (exact_*.cpp, fast_*.cpp). Releases have these sealed.
bool is_second_answer(const std::filesystem::path& given);

/// The lines (solution_lines) of the solutions of `steps` with at least min_line_length bytes, except those that are
/// also in common/, in the contract or given code of a step (without second answers), in a skeleton, or in the solution
/// of a step not in `steps`.
std::set<std::string> distinctive_lines(const ProjectFolders& folders, const std::vector<CourseStep>& course,
                                        const std::vector<CourseStep>& steps);

struct Leak {
  std::string file, line;
};

/// Every occurrence of `lines` in the text files (files without a null byte), in the order of the files.
std::vector<Leak> find_leaks(const grade::PackedFiles& files, const std::set<std::string>& lines);

}  // namespace atelier
