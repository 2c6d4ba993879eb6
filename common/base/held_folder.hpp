// A folder that is held by a descriptor, for files that an untrusted program writes.
//
// A program may rename its folder and put a link to another one at the old path. A descriptor stays with the folder:
// what is read and removed through it is in the folder that was opened, whatever the path leads to by then.
#pragma once

#include <filesystem>
#include <string>

#include "base/descriptor.hpp"

namespace atelier {

/// Each `name` below is that of an entry of this folder, without '/'.
class HeldFolder {
 public:
  /// Opens a folder, before the program that may exchange it starts. Throws Error naming the path if it is missing, not
  /// a folder, or a symbolic link.
  explicit HeldFolder(std::filesystem::path path);

  /// A folder of another file system's view, which `folder` holds open and this process cannot reach by its path.
  static HeldFolder received(std::filesystem::path path, Descriptor folder);

  const std::filesystem::path& path() const { return path_; }  ///< where it was when it was opened
  /// Whether path() still leads to this folder; of one that was received, true. Only for messages: the answer may
  /// change at once.
  bool in_place() const;

  /// A new folder in this one. Throws Error with the system's reason, also if the name exists.
  HeldFolder create_folder(const std::string& name) const;

  /// Opens a file for reading. Neither follows a link nor blocks on a FIFO; what it has opened may still be a folder, a
  /// pipe or a device. Without success the descriptor is invalid and errno is set (ELOOP: a symbolic link).
  Descriptor open_file(const std::string& name) const;
  bool has(const std::string& name) const;  ///< an entry of any kind, also a link that leads nowhere
  /// Removes a file, or a link but not what it leads to. Whatever cannot be removed stays; so do folders.
  void remove_file(const std::string& name) const noexcept;
  /// Removes all that is in this folder, and nothing that links in it lead to. Whatever cannot be removed stays.
  void remove_contents() const;

 private:
  HeldFolder(std::filesystem::path path, Descriptor folder);

  std::filesystem::path path_;
  Descriptor folder_;
  bool received_ = false;
};

}  // namespace atelier
