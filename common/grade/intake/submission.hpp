// Takes a submission: the steps' files out of folders, archives and single files. Only the files that a step lists are
// read.
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
  std::filesystem::path source;   ///< the folder that holds all present steps as NN-name/; empty: there is none
  std::filesystem::path folder;   ///< the private copy: NN-name/FILE, regular files only
  std::set<std::string> present;  ///< the steps with at least something handed in

  std::map<std::string, judge::UnusableFiles> unusable;  ///< by present step: its unusable or missing files, and why
  std::map<std::string, std::string> skipped;            ///< steps whose folder is unusable: "is a symbolic link ..."
  std::set<std::string> untouched;  ///< present steps, all of whose files are those of the skeleton: not handed in

  // All texts below are printable; each list has at most max_notes entries.
  std::vector<std::string> notes;  ///< what was skipped, found in an unexpected place or converted, a sentence each
  std::vector<std::string> needs_human;  ///< why a person must look at it, a sentence each; empty: nobody must
  std::vector<std::string> taken;        ///< "02-light: light.cpp, light.glsl", by step
  std::vector<std::string> ignored;      ///< files that were not read, with the reason where it is not plain
};

inline constexpr std::size_t max_notes = 20;  ///< if there are more, the last entry says how many

/// Copies each usable listed file of each step (judge/run/source_file.hpp) into `folder`, which is created if missing.
/// A step's files are found as grade/intake/step_places.hpp says; a step is present if its folder exists or, elsewhere,
/// any of its listed files. Texts become UTF-8 with LF (grade/intake/text_conversion.hpp), with a note. Throws Error
/// naming `source` if it is missing, cannot be read, is the folder of one step, has steps in two folders side by side,
/// or has none of the steps; the message says what was found instead.
/// Of a step in several places, a copy that is not as in SKELETONS/NN-name/ counts first; `skeletons` may be empty.
Submission take_submission(const judge::StepFlags& flags, const std::filesystem::path& source,
                           const std::filesystem::path& folder, const std::filesystem::path& skeletons = {});

/// The same of several versions that one student has handed in, the newest last: folders, archives and single files.
/// Of a step in several, the last one's files count, with a note; single files count together as one version, the last.
/// A step of which all present files are as in SKELETONS/NN-name/, up to line ends, encoding and blanks at the ends of
/// lines, is untouched, and counts only where no changed copy is, in any version; a person must look at it if a file
/// beside it could be work on the step. `skeletons` may be empty. Whatever is in the sources, nothing is thrown: what
/// cannot be read or is in doubt is in `needs_human`. Throws Error only if `folder` cannot be written.
Submission take_submission(const judge::StepFlags& flags, const std::vector<std::filesystem::path>& sources,
                           const std::filesystem::path& folder, const std::filesystem::path& skeletons = {});

/// A seed for the numbers that are drawn for a submission (grade/varied_cases.hpp), 0..max_seed: a hash of the names
/// and bytes of the files in its private copy. So a regrade repeats it, wherever the submission lies, and who edits a
/// file changes it.
std::uint64_t seed_of(const Submission& submission);

}  // namespace atelier::grade
