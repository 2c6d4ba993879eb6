// Patches on a step's solution, as tests/mistakes/ and tests/variants/ hold them: written, and renewed where the
// solution has changed.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace atelier {

/// A step's files by their names.
using Sources = std::map<std::string, std::string>;

/// The regular files of a folder. Throws Error where there is no such folder.
Sources sources_of(const std::filesystem::path& folder);

/// The files as they are in git at a revision, `folder` being relative to `root`. Throws Error with git's words.
Sources sources_at(const std::filesystem::path& root, const std::string& revision, const std::string& folder);

/// The patch that makes `after` of `before`, as `diff -u` with the paths a/FILE and b/FILE; empty where nothing
/// differs. Throws Error where the names of the files are not the same.
std::string patch_between(const Sources& before, const Sources& after);

struct Renewed {
  enum class State {
    as_it_was,  ///< it still makes what it is to make
    renewed,
    conflict,       ///< both have changed the same lines
    lost,           ///< the solution now does what the patch did
    not_on_before,  ///< the patch does not apply to the solution that it is said to be for
  } state = State::as_it_was;
  std::string text;  ///< of a patch that is renewed
};

/// A patch on `before` as one on `now`, by a merge of three (cli/merge.hpp).
Renewed renewed_patch(const std::filesystem::path& patch, const Sources& before, const Sources& now);

}  // namespace atelier
