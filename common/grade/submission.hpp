// Reads a submission, a folder or a ZIP. Only the files that a step lists are read.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "judge/run/build.hpp"

namespace atelier::grade {

struct Submission {
  std::string name;               ///< of the folder or the archive, printable
  std::filesystem::path source;   ///< the folder that holds the steps' folders; empty for an archive
  std::filesystem::path folder;   ///< the private copy: NN-name/FILE, regular files only
  std::set<std::string> present;  ///< the steps with at least something handed in

  std::map<std::string, judge::UnusableFiles> unusable;  ///< by present step: its unusable or missing files, and why
  std::map<std::string, std::string> skipped;            ///< steps whose folder is unusable: "is a symbolic link ..."
  std::vector<std::string> notes;  ///< what was skipped, one entry each, printable; at most max_notes
};

inline constexpr std::size_t max_notes = 20;  ///< if there are more, the last entry says how many

/// Copies each usable listed file of each step (judge/run/source_file.hpp) into `folder`, which is created if missing;
/// UTF-16 becomes UTF-8, with a note. The steps' folders are in `source`, or in the only folder that has any on the
/// next level below it. A step is present if its folder exists or, in an archive, any of its listed files. Throws Error
/// naming `source` if it is neither a folder nor a valid ZIP, or has none of the steps; the message says where steps
/// were found.
Submission take_submission(const judge::StepFlags& flags, const std::filesystem::path& source,
                           const std::filesystem::path& folder);

/// A seed for the numbers that are drawn for a submission (grade/varied_cases.hpp), 0..max_seed: a hash of the names
/// and bytes of the files in its private copy. So a regrade repeats it, wherever the submission lies, and who edits a
/// file changes it.
std::uint64_t seed_of(const Submission& submission);

}  // namespace atelier::grade
