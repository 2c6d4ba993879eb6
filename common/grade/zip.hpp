// Writes ZIP archives for releases and submissions. archive.hpp reads them.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace atelier::grade {

/// A file to be written to an archive or a folder.
struct PackedFile {
  std::string bytes;
  bool executable = false;
};

/// Files by relative path with slashes: "02-blinn-phong/blinn_phong.cpp".
using PackedFiles = std::map<std::string, PackedFile>;

/// A deflated archive of `files`, in the order of their paths, all with the same date. So the same files give the same
/// bytes (within one time zone, since ZIP stores local time). Throws Error naming the path that the library refuses.

std::string make_zip(const PackedFiles& files);

}  // namespace atelier::grade
