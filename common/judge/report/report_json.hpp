// results.json: what other programs read.
//
//   {"submission", "score", "max_score",
//    "steps": [{"step", "title", "score", "max_score", "implementations": {STEP: WHO}, "build_log",
//       "cases": [{"name", "title", "status", "score", "max_score", "reason", "mistake": NAME or null, "hint",
//          "asked", "mistake_sentence", "credit", "command", "figures": {NAME: NUMBER}, "table", "output",
//          "worst": null or {"x", "y", "yours": [r,g,b,a], "reference": [r,g,b,a]}}]}],
//    "environment": {"driver", "context", "compiler", ...},
//    "notes": [TEXT]}                    what of the submission was passed over: links, files too large, paths that
//    climb
//
// `status` is one of passed, failed, missing, crashed, timeout, build_failed. Points are rounded to millionths, so that
// sums of thirds compare equal. Non-finite numbers are "nan", "inf", "-inf".
#pragma once

#include <filesystem>
#include <string>

#include "judge/compare/result.hpp"

namespace atelier::judge {

/// Valid JSON in UTF-8, whatever the texts hold: bytes that are no UTF-8 become U+FFFD, control characters are escaped.
std::string results_json(const SubmissionResult& result);

/// Throws Error naming the file where it cannot be written; what stood there stays then.
void write_results_json(const std::filesystem::path& file, const SubmissionResult& result);

}  // namespace atelier::judge
