// Small pictures of recognised mistakes, for the report of the class. They are not in the folder that a student gets,
// whose report may show less.
#pragma once

#include <filesystem>
#include <string>

#include "grade/results/record.hpp"
#include "judge/compare/result.hpp"

namespace atelier::grade {

inline constexpr int mistake_picture_side = 400;               ///< pixels at most: yours | reference | difference
inline constexpr std::size_t mistake_picture_limit = 200'000;  ///< bytes; a larger file is not shown

/// Where the pictures of a submission are in the folder of the results: pictures/ID.
std::filesystem::path pictures_folder(const std::filesystem::path& results, const SubmissionRecord& record);

/// Writes NN-name.MISTAKE.png into the folder `pictures` for each mistake that a case with pictures shows: the
/// first such case of the step. Writes and creates nothing if there is none. To be called with the whole result, before
/// limit_feedback. Throws Error naming a file that cannot be written.
void write_mistake_pictures(const std::filesystem::path& pictures, const judge::SubmissionResult& result);

/// Where the call above writes the picture of a mistake.
std::filesystem::path mistake_picture(const std::filesystem::path& pictures, const std::string& step,
                                      const std::string& mistake);

}  // namespace atelier::grade
