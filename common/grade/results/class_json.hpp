// class.json: what class.html shows, for programs.
//
//   {"schema": 1, "class", "course", "platform", "seconds",
//    "steps": [{"step", "title", "max_points", "bins": [11 numbers], "handed_in", "not_built", "untouched", "absent",
//               "median", "mean"}],
//    "students": [{"id", "name", "identifier", "points", "max_points", "adjustment", "comment", "late",
//                  "handed_in": SECONDS or null, "report", "sandbox", "seconds", "needs_human": [TEXT],
//                  "steps": [{"step", "state", "points", "max_points", "penalty", "days_late",
//                             "mistakes": {NAME: CASES}}]}],
//    "mistakes": [{"step", "mistake", "title", "sentence", "students": [ID], "cases"}],
//    "needs_human": [{"reason", "students": [ID]}], "slowest": [ID], "sandboxes": {TIER: NUMBER},
//    "misplaced_comments": [TEXT], "ignored": [TEXT], "environment": {NAME: TEXT}}
//
// "handed_in" of a student is in seconds since 1970, UTC; "bins" are as in StepStatistics.
#pragma once

#include <string>

#include "grade/results/class_results.hpp"

namespace atelier::grade {

/// Always valid JSON in UTF-8.
std::string class_json(const ClassResults& results);

}  // namespace atelier::grade
