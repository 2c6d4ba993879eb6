#include "cli/grader/temporary_place.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <random>
#include <system_error>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/launch.hpp"
#include "base/system_reason.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;

constexpr const char* place_prefix = "atelier-class-";
constexpr mode_t place_mode = 0711;  ///< confined programs go through it to what they may use

/// Only a folder of ours is removed, whatever the file says.
bool is_ours(const fs::path& folder) {
  struct stat status {};
  return folder.is_absolute() && folder.filename().string().starts_with(place_prefix) &&
         ::lstat(folder.c_str(), &status) == 0 && S_ISDIR(status.st_mode) && status.st_uid == ::geteuid();
}

void remove_left(const fs::path& file) {
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return;
  const fs::path left = read_file(file);
  if (is_ours(left)) {
    HeldFolder(left).remove_contents();
    fs::remove(left, ignored);
  }
  fs::remove(file, ignored);
}

fs::path unused_path() {
  std::random_device random;
  return temporary_parent() / fmt::format("{}{:08x}{:08x}", place_prefix, random(), random());
}

void make_folder(const fs::path& folder) {
  if (::mkdir(folder.c_str(), place_mode) != 0 || ::chmod(folder.c_str(), place_mode) != 0)
    throw Error(fmt::format("{}: cannot be created: {}", folder.string(), system_reason()));
}

}  // namespace

TemporaryPlace::TemporaryPlace(fs::path file) : file_(std::move(file)), environment_before_(own_environment()) {
  remove_left(file_);
  const fs::path folder = fs::absolute(unused_path());
  write_file(file_, folder.string());
  make_folder(folder);
  folder_.emplace(folder);
  ::setenv("TMPDIR", folder.c_str(), 1);
}

TemporaryPlace::~TemporaryPlace() {
  if (const auto before = environment_before_.find("TMPDIR"); before != environment_before_.end())
    ::setenv("TMPDIR", before->second.c_str(), 1);
  else
    ::unsetenv("TMPDIR");
  folder_->remove_contents();
  std::error_code ignored;
  fs::remove(folder_->path(), ignored);
  fs::remove(file_, ignored);
}

fs::path TemporaryPlace::empty_folder(const std::string& name) const {
  const fs::path folder = folder_->path() / name;
  if (std::error_code missing; fs::is_directory(fs::symlink_status(folder, missing)))
    HeldFolder(folder).remove_contents();
  else
    make_folder(folder);
  return folder;
}

}  // namespace atelier
