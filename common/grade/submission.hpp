// A submission on its way in: a folder or a ZIP, of which only the files that a step lists are ever looked at.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "judge/build.hpp"

namespace atelier::grade {

struct Submission {
  std::string name;               ///< of the folder or the archive, printable
  std::filesystem::path folder;   ///< the private copy: NN-name/FILE, regular files only
  std::set<std::string> present;  ///< the steps of which something was handed in
};

/// Takes a submission into `folder` (made where missing): each listed file of each step where it is a regular file (no
/// link, no device), at most judge::source_limit bytes. A step is present where its folder is there, or, in an archive,
/// any of its files; what is missing of it shows when it is built. Throws Error naming `source` where it is neither a
/// folder nor a sound ZIP, or has none of the steps.
Submission take_submission(const judge::StepFlags& flags, const std::filesystem::path& source,
                           const std::filesystem::path& folder);

}  // namespace atelier::grade
