// results.json: the results for other programs.
//
//   {"submission", "score", "max_score",
//    "steps": [{"step", "title", "score", "max_score", "implementations": {STEP: WHO}, "build_log",
//       "cases": [{"name", "title", "status", "score", "max_score", "reason", "mistake": NAME or null, "hint",
//          "asked", "mistake_sentence", "credit", "command", "figures": {NAME: NUMBER}, "table", "output",
//          "worst": null or {"x", "y", "yours": [r,g,b,a], "reference": [r,g,b,a]}}]}],
//    "environment": {"driver", "context", "compiler", ...},
//    "notes": [TEXT]}                    what was skipped, found elsewhere or converted in the submission
//
// `status` is one of passed, failed, missing, crashed, timeout, build_failed. Points are rounded to millionths, so that
// sums of thirds compare equal. Non-finite numbers are "nan", "inf", "-inf".
#pragma once

#include <filesystem>
#include <string>

#include "judge/compare/result.hpp"

namespace atelier::judge {

/// Always valid JSON in UTF-8: bytes that are not UTF-8 become U+FFFD, control characters are escaped.
std::string results_json(const SubmissionResult& result);

/// Throws Error naming the file if it cannot be written; the old file is then unchanged.
void write_results_json(const std::filesystem::path& file, const SubmissionResult& result);

}  // namespace atelier::judge
