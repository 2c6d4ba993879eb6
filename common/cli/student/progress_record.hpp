// A student's progress, in progress.json beside ./atelier: for each step the last full check and the hints shown.
//
//   {"schema": 1,
//    "steps": {
//      "02-blinn-phong": {
//        "best": 63.03,
//        "check": {"when": "2025-03-01T09:30:00Z", "score": 34.5, "max_score": 100, "files": SHA-256 of the files,
//                  "cases": {"sphere": true, "edges": false, ...}},          whether each passed
//        "hints": {"edges": 2}}}}                                            the highest level shown, 1..3
//
// git ignores the file; an update of the course does not change it, and it can be copied to another machine. A record
// identifies the judged files by their hash: a pass counts for exactly these files, in any folder, independent of file
// times.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "judge/compare/result.hpp"

namespace atelier {

/// The last check of all cases of a step.
struct CheckRecord {
  std::string when;                   ///< UTC, "2025-03-01T09:30:00Z"; only for display
  double score = 0, max_score = 0;    ///< points
  std::string files;                  ///< digest_of_files() of the judged files
  std::map<std::string, bool> cases;  ///< by name: whether it passed
  std::string begin_with;             ///< the case that the verdict began with; empty: every case passed, or not known
  std::string wrong_function;         ///< that the verdict began with; empty: none

  int passed() const;  ///< how many of the cases
};

struct StepProgress {
  std::optional<CheckRecord> check;  ///< absent before the first full check
  double best = 0;                   ///< the highest score of any full check
  std::map<std::string, int> hints;  ///< by case: the highest level shown, 1..most_hints
};

inline constexpr int most_hints = 3;

/// By step: "02-blinn-phong". Steps that this copy of the course does not have are kept.
using ProgressRecord = std::map<std::string, StepProgress>;

/// Reads the record; empty if there is no such file. If it is invalid, throws Error naming the file, the member, what
/// is allowed and the workaround (to move the file away).
ProgressRecord read_progress(const std::filesystem::path& file);

/// Writes the record atomically.
void write_progress(const std::filesystem::path& file, const ProgressRecord& record);

/// Reads, changes and writes the record under a lock, so that two processes do not lose each other's changes.
void change_progress(const std::filesystem::path& file, const std::function<void(ProgressRecord&)>& change);

/// Records a check of all cases, of files with this hash, at the current time. Hints stay.
void record_check(ProgressRecord& record, const judge::StepResult& result, const std::string& files);

/// The level of the last hint shown for a case: 0 (none yet) .. most_hints.
int hint_level(const ProgressRecord& record, const std::string& step, const std::string& case_name);

/// Records that a hint of this level, 1..most_hints, was shown; never lowers the level.
void raise_hint_level(ProgressRecord& record, const std::string& step, const std::string& case_name, int level);

/// One digest (SHA-256) of a step's files below `folder`, names and bytes; a missing file changes the hash too.
std::string digest_of_files(const std::filesystem::path& folder, const std::vector<std::string>& files);

/// Whether the last full check passed each of `cases` (all of the step's current cases) with files of this hash.
bool has_passed(const StepProgress& progress, const std::vector<std::string>& cases, const std::string& files);

}  // namespace atelier
