// Updates a student's files to the skeletons of a release without losing edits.
//
//   skeletons/NN-name/FILE    from the release; unpacking a newer release changes these
//   .given/NN-name/FILE       the last given version, for detecting a student's edits
//   steps/NN-name/FILE        the student's file; no release has such a file
//   steps/skeletons.sha256    hashes of untouched files (skeleton_record.hpp)
//
// For every FILE:
//   not there                       it is given, also after the student has deleted it to start again
//   untouched                       it is replaced by the new skeleton
//   edited, the skeleton as before  it does not change
//   edited, a new skeleton          git merges both changes, and FILE.before-merge keeps the student's file; without
//                                   git, if both have changed the same lines (not only comments), or if the given
//                                   version is unknown: FILE does not change, and the new skeleton is FILE.new
// Renamed identifiers (renames.hpp) are first changed in the student's file; FILE.before-merge keeps the old version.
// .given/renames.txt lists the renames that have been applied.
#pragma once

#include <string>
#include <vector>

#include "cli/layout.hpp"

namespace atelier {

/// Does nothing without a folder skeletons/; if nothing is new it only compares a few small files. Existing names get a
/// number (FILE.new-2), so nothing is overwritten. Returns a line for each file that was given, replaced, merged or
/// written as FILE.new. Throws Error naming a file that cannot be read or written.
std::vector<std::string> update_skeletons(const ProjectFolders& folders);

}  // namespace atelier
