// A submission on its way in: a folder or a ZIP, of which only the files that a step lists are ever looked at.
#pragma once

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
  std::set<std::string> present;  ///< the steps of which something was handed in

  std::map<std::string, judge::NotTaken> not_taken;  ///< by step, of those present: what is missing, and why
  std::map<std::string, std::string> passed_over;  ///< steps whose folder could not be taken: "is a symbolic link ..."
  std::vector<std::string> notes;  ///< what was passed over, an entry each, printable and at most most_notes
};

inline constexpr std::size_t most_notes = 20;  ///< the last one then says how many more there are

/// Takes a submission into `folder` (made where missing): each listed file of each step that can be taken
/// (judge/run/source_file.hpp). The steps' folders stand in `source`, or in the one folder inside that has any. A step
/// is present where its folder is there, or, in an archive, any of its listed files. Throws Error naming `source` where
/// it is neither a folder nor a sound ZIP, or has none of the steps; it then says where some were found.
Submission take_submission(const judge::StepFlags& flags, const std::filesystem::path& source,
                           const std::filesystem::path& folder);

}  // namespace atelier::grade
