// Patches on a step's solution, as in tests/mistakes/ and tests/variants/: creates them, and updates them when the
// solution has changed.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace atelier {

/// A step's files by their names.
using Sources = std::map<std::string, std::string>;

/// The regular files of a folder. Throws Error if there is no such folder.
Sources sources_of(const std::filesystem::path& folder);

/// The files at a git revision; `folder` is relative to `root`. Throws Error with git's message.
Sources sources_at(const std::filesystem::path& root, const std::string& revision, const std::string& folder);

/// The patch from `before` to `after`, as `diff -u` with the paths a/FILE and b/FILE; empty if nothing differs. Throws
/// Error if the file names differ.
std::string patch_between(const Sources& before, const Sources& after);

struct Renewed {
  enum class State {
    as_it_was,  ///< it still applies with the same result
    renewed,
    conflict,       ///< both have changed the same lines
    lost,           ///< the solution now does what the patch did
    not_on_before,  ///< the patch does not apply to the given old solution
  } state = State::as_it_was;
  std::string text;  ///< of an updated patch
};

/// Converts a patch on `before` to one on `now`, by a three-way merge (cli/merge.hpp).
Renewed renewed_patch(const std::filesystem::path& patch, const Sources& before, const Sources& now);

}  // namespace atelier
