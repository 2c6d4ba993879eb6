// Finds the submissions of a class in what an instructor has downloaded from a course platform.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "grade/results/record.hpp"
#include "judge/run/build.hpp"

namespace atelier::grade {

/// One submission of a class: all versions of one student together.
struct HandedIn {
  Student student;
  std::vector<std::filesystem::path>
      sources;                            ///< folders, archives and files; of a step in several, the last one's counts
  std::string source;                     ///< the last one, relative to the class's folder, printable
  std::optional<std::int64_t> handed_in;  ///< seconds since 1970, UTC, if the platform says it
  bool late = false;                      ///< the platform marks it as late
  std::vector<std::string> notes;         ///< "homework-1.zip is newer and counts"
  std::vector<std::string> needs_human;   ///< why a person must look at it
};

struct ClassFolder {
  std::string platform;               ///< "moodle", "canvas", "gradescope", "github", "pattern" or "folders"
  std::vector<HandedIn> submissions;  ///< sorted by id
  std::vector<std::string> ignored;   ///< entries that are no submission, each with the reason; printable
};

struct ClassNaming {
  /// A regular expression (ECMAScript) for the names of entries, with groups in this order: name, identifier; the
  /// second may be absent. Empty: the platform's naming is recognised.
  std::string pattern;
};

/// Whether `sources` are a class: several paths, or one folder (or archive) that is no submission itself but has some
/// in it. A class is never taken for one student.
bool is_class(const judge::StepFlags& flags, const std::vector<std::filesystem::path>& sources);

/// Throws Error naming the folder if it has no submission, and for a pattern that is none.
ClassFolder find_submissions(const judge::StepFlags& flags, const std::vector<std::filesystem::path>& sources,
                             const std::filesystem::path& unpacked, const ClassNaming& naming = {});

}  // namespace atelier::grade
