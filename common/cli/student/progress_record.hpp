// What a student has reached, in progress.json beside ./atelier: by step the last full check and the hints shown.
//
//   {"schema": 1,
//    "steps": {
//      "02-blinn-phong": {
//        "best": 63.03,
//        "check": {"when": "2025-03-01T09:30:00Z", "score": 34.5, "max_score": 100, "files": SHA-256 of the files,
//                  "cases": {"sphere": true, "edges": false, ...}},          whether each passed
//        "hints": {"edges": 2}}}}                                            the highest level shown, 1..3
//
// The file is git's to ignore and the student's to keep: an update of the course leaves it alone, and it can be copied
// to another machine by hand. A record is about the files that were judged, by their digest: a pass counts for the very
// same files wherever they lie, and no clock is asked.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "judge/compare/result.hpp"

namespace atelier {

/// The last check that asked for every case of a step.
struct CheckRecord {
  std::string when;                   ///< UTC, "2025-03-01T09:30:00Z"; for people, nothing is decided by it
  double score = 0, max_score = 0;    ///< points
  std::string files;                  ///< digest_of_files() of what was judged
  std::map<std::string, bool> cases;  ///< by name: whether it passed

  int passed() const;  ///< how many of the cases
};

struct StepProgress {
  std::optional<CheckRecord> check;  ///< absent before the first full check
  double best = 0;                   ///< the highest score of any full check
  std::map<std::string, int> hints;  ///< by case: the highest level shown, 1..most_hints
};

inline constexpr int most_hints = 3;

/// By step: "02-blinn-phong". A step that this copy of the course does not have is kept.
using ProgressRecord = std::map<std::string, StepProgress>;

/// The record in a file; empty where there is no such file. Throws Error naming the file, the member, what is allowed
/// and the way out (to move the file away) where it is broken.
ProgressRecord read_progress(const std::filesystem::path& file);

/// Writes the whole record beside and renames it.
void write_progress(const std::filesystem::path& file, const ProgressRecord& record);

/// Reads the record, has it changed, and writes it, while no other process does so: two terminals lose nothing.
void change_progress(const std::filesystem::path& file, const std::function<void(ProgressRecord&)>& change);

/// Takes down a check of all cases, of files with this digest, as of now. Hints stay.
void record_check(ProgressRecord& record, const judge::StepResult& result, const std::string& files);

/// The level of the last hint shown for a case: 0 (none yet) .. most_hints.
int hint_level(const ProgressRecord& record, const std::string& step, const std::string& case_name);

/// Takes down that a hint of this level, 1..most_hints, was shown; never lowers the level.
void raise_hint_level(ProgressRecord& record, const std::string& step, const std::string& case_name, int level);

/// One digest (SHA-256) of a step's files below `folder`, names and bytes; a file that is not there counts as such.
std::string digest_of_files(const std::filesystem::path& folder, const std::vector<std::string>& files);

/// Whether the last full check passed each of `cases` (all that the step has now) with the files of this digest.
bool has_passed(const StepProgress& progress, const std::vector<std::string>& cases, const std::string& files);

}  // namespace atelier
