// The files of a submission that may belong to a step, wherever they are: in folders, in archives, in archives in them.
//
// Archives count as folders of their names: "hw.zip/01-move/move.cpp".
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "judge/run/build.hpp"

namespace atelier::grade {

struct SourceFile {
  std::filesystem::path at;  ///< on the disk; empty: a member of an archive
  std::string bytes;         ///< of a member
  std::string why_unusable;  ///< of a member; empty: usable
};

struct SourceFiles {
  std::map<std::string, SourceFile> files;  ///< those with a listed name, by relative path with slashes
  /// Entries of a folder on the disk with the exact name of a step, by relative path; and why it is no folder, or
  /// empty.
  std::map<std::string, std::string> step_folders;
  std::vector<std::string> others;    ///< paths of other files, without what systems and compilers add; at most 1000
  bool has_folders_of_steps = false;  ///< a path leads through a folder with the exact name of a step
  std::vector<std::string> notes;     ///< what was skipped, each with the reason; printable
  std::vector<std::string> unread;    ///< archives that could not be read, and limits that were reached; printable
};

/// Limits on one source: a folder or an archive with all that is in it.
struct SourceLimits {
  std::size_t entries = 20'000;  ///< of folders on the disk
  int folder_levels = 16;
  int archives = 32;        ///< in folders and archives, read or not
  int broken_archives = 4;  ///< after as many that cannot be read, no more is: each may have cost what is allowed
  int archive_levels = 3;   ///< archives in archives
  std::size_t inflated_bytes = 256 << 20;  ///< of all archives together
};

/// Looks through a folder, the nearest levels first, or an archive. Links are never followed; the folders that Macs,
/// version control and Visual Studio keep are passed over. An archive in it that cannot be read is listed in `unread`;
/// if `source` itself cannot be, throws Error as read_archive does.
SourceFiles read_source(const judge::StepFlags& flags, const std::filesystem::path& source,
                        const SourceLimits& limits = {});

/// Single files, by the names that they had when they were uploaded, as if they lay in one folder.
SourceFiles read_loose_files(const judge::StepFlags& flags,
                             const std::vector<std::pair<std::string, std::filesystem::path>>& files);

}  // namespace atelier::grade
