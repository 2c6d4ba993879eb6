// The files with the result of one submission.
#pragma once

#include <filesystem>

#include "judge/compare/result.hpp"

namespace atelier {

/// Draws the pictures of errors, then writes report.html, results.json and junit.xml into `folder`, which exists: all
/// of them or, with an Error, none.
void write_result_files(judge::SubmissionResult& result, const std::filesystem::path& folder);

/// Removes these files, if they are there: they are of an earlier submission.
void remove_result_files(const std::filesystem::path& folder);

}  // namespace atelier
