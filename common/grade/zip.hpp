// Makes a ZIP archive: what students are handed, and what they hand in. unzip.hpp is the way back.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace atelier::grade {

/// A file on its way into an archive or a folder.
struct PackedFile {
  std::string bytes;
  bool executable = false;
};

/// By the path of each, relative and with slashes: "02-blinn-phong/blinn_phong.cpp".
using PackedFiles = std::map<std::string, PackedFile>;

/// The archive of `files`, deflated, in the order of their paths, all of the same date: the same files make the same
/// bytes (in one time zone: a ZIP knows local time alone). Throws Error naming the path that the archive library does
/// not take.
std::string make_zip(const PackedFiles& files);

}  // namespace atelier::grade
