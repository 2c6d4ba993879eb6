#include "base/held_folder.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <memory>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/system_reason.hpp"

namespace atelier {
namespace {

constexpr int folder_flags = O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC;

std::vector<std::string> names_in(int folder) {
  std::vector<std::string> names;
  const int again = ::openat(folder, ".", folder_flags);  // an own position in the list of entries
  const std::unique_ptr<DIR, int (*)(DIR*)> list(again < 0 ? nullptr : ::fdopendir(again), ::closedir);
  if (!list && again >= 0) ::close(again);
  while (const dirent* entry = list ? ::readdir(list.get()) : nullptr)
    if (const std::string name = entry->d_name; name != "." && name != "..") names.push_back(name);
  return names;
}

/// Removes the files in `folder` and in its folders, and these folders. The folders in them move up into `folder`,
/// under new names numbered by `moved`. So it holds two descriptors however deep a program has nested its folders.
/// Returns whether a folder has moved up.
bool remove_level(int folder, unsigned& moved) {
  bool has_moved = false;
  for (const std::string& name : names_in(folder)) {
    if (::unlinkat(folder, name.c_str(), 0) == 0) continue;
    const Descriptor inner(::openat(folder, name.c_str(), folder_flags));
    if (!inner) continue;
    for (const std::string& each : names_in(inner.get())) {
      if (::unlinkat(inner.get(), each.c_str(), 0) == 0) continue;
      has_moved |= ::renameat(inner.get(), each.c_str(), folder, fmt::format(".moved-{}", moved++).c_str()) == 0;
    }
    ::unlinkat(folder, name.c_str(), AT_REMOVEDIR);
  }
  return has_moved;
}

}  // namespace

HeldFolder::HeldFolder(std::filesystem::path path) : HeldFolder(path, Descriptor(::open(path.c_str(), folder_flags))) {}

HeldFolder::HeldFolder(std::filesystem::path path, Descriptor folder)
    : path_(std::move(path)), folder_(std::move(folder)) {
  if (!folder_) throw Error(fmt::format("{}: cannot be opened as a folder: {}", path_.string(), system_reason()));
}

HeldFolder HeldFolder::received(std::filesystem::path path, Descriptor folder) {
  HeldFolder held(std::move(path), std::move(folder));
  held.received_ = true;
  return held;
}

bool HeldFolder::in_place() const {
  if (received_) return true;
  struct stat held {
  }, there{};
  return ::fstat(folder_.get(), &held) == 0 && ::lstat(path_.c_str(), &there) == 0 && held.st_dev == there.st_dev &&
         held.st_ino == there.st_ino;
}

HeldFolder HeldFolder::create_folder(const std::string& name) const {
  if (::mkdirat(folder_.get(), name.c_str(), 0777) != 0)
    throw Error(fmt::format("{}: cannot be created: {}", (path_ / name).string(), system_reason()));
  return HeldFolder(path_ / name, Descriptor(::openat(folder_.get(), name.c_str(), folder_flags)));
}

Descriptor HeldFolder::open_file(const std::string& name) const {
  return Descriptor(::openat(folder_.get(), name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
}

bool HeldFolder::has(const std::string& name) const {
  struct stat status {};
  return ::fstatat(folder_.get(), name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0;
}

void HeldFolder::remove_file(const std::string& name) const noexcept {
  ::unlinkat(folder_.get(), name.c_str(), 0);
}

void HeldFolder::remove_contents() const {
  constexpr int max_levels = 100'000;  // a process that has left its group may add folders without end
  unsigned moved = 0;
  for (int level = 0; level < max_levels && remove_level(folder_.get(), moved); ++level) {
  }
}

}  // namespace atelier
