// Small pictures of recognised mistakes, kept beside a student's report for the report of the class.
#pragma once

#include <filesystem>
#include <string>

#include "judge/compare/result.hpp"

namespace atelier::grade {

inline constexpr int mistake_picture_side = 400;               ///< pixels at most: yours | reference | difference
inline constexpr std::size_t mistake_picture_limit = 200'000;  ///< bytes; a larger file is not shown

/// Writes mistakes/NN-name.MISTAKE.png into the folder `student` for each mistake that a case with pictures shows: the
/// first such case of the step. Writes and creates nothing if there is none. To be called with the whole result, before
/// limit_feedback. Throws Error naming a file that cannot be written.
void write_mistake_pictures(const std::filesystem::path& student, const judge::SubmissionResult& result);

/// Where the call above writes the picture of a mistake.
std::filesystem::path mistake_picture(const std::filesystem::path& student, const std::string& step,
                                      const std::string& mistake);

}  // namespace atelier::grade
