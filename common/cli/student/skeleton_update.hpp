// Brings the skeletons of a release to a student's files, and a newer release's over edited ones, without losing a
// word.
//
//   skeletons/NN-name/FILE    what the release brings; unpacking a newer release changes these
//   .given/NN-name/FILE       what was given last, so that a student's edits can be told from it
//   steps/NN-name/FILE        the student's own; no release has such a file
//   steps/skeletons.sha256    what an untouched file is (skeleton_record.hpp)
//
// Of every FILE:
//   not there                       it is given, also where the student has deleted it to start again
//   as it was given                 the new skeleton takes its place
//   edited, the skeleton as before  it stays
//   edited, a new skeleton          the changes of both are merged by git, and FILE.before-merge keeps the student's;
//                                   without git, where both have changed the same lines and not the comments alone,
//                                   or where it is not known what was given: the student's stays, and the new skeleton
//                                   lies beside as FILE.new
// Names that a release has changed (renames.hpp) are changed in the student's file first; FILE.before-merge keeps it as
// it was. .given/renames.txt says which of them the files have been through.
#pragma once

#include <string>
#include <vector>

#include "cli/layout.hpp"

namespace atelier {

/// Does this where the project has a folder skeletons/; costs a comparison of a few small files where nothing is new.
/// A name that is taken gets a number (FILE.new-2), so nothing is overwritten. Returns a line for each file that was
/// given, replaced, merged or put beside. Throws Error naming what cannot be read or written.
std::vector<std::string> update_skeletons(const ProjectFolders& folders);

}  // namespace atelier
