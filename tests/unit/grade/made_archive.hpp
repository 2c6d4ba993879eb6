// Archives as students and platforms make them, and as no decent program would write them.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "grade/intake/archive.hpp"
#include "judge/run/build.hpp"

namespace atelier::test {

struct Member {
  std::string name, bytes;
  std::string link = {};  ///< makes it a symbolic link to this
};

/// Writes an archive with libarchive, names as they are: also those that no decent program would write. The format
/// follows from the file's extension. With a password the members are encrypted (ZIP only).
void write_archive(const std::filesystem::path& file, const std::vector<Member>& members,
                   const std::string& password = {});

/// The bytes of such an archive.
std::string archive_bytes(const std::string& name, const std::vector<Member>& members);

struct ReadMembers {
  std::map<std::string, std::string> files;
  grade::ArchiveContents contents;
};

/// The members with these names.
ReadMembers read_members(const std::filesystem::path& file, const std::set<std::string>& wanted,
                         const grade::ArchiveLimits& limits = {});

/// A course of three steps; two have a file of the same name.
inline const judge::StepFlags three_steps{.files = {{"01-move", {"move.cpp"}},
                                                    {"02-light-up", {"light.cpp", "light.glsl", "choices.txt"}},
                                                    {"03-cast-shadows", {"shadows.cpp", "choices.txt"}}}};

}  // namespace atelier::test
