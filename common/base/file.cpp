#include "base/file.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>
#include <vector>

#include "base/descriptor.hpp"
#include "base/error.hpp"
#include "base/system_reason.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;

/// A unique name in the target's folder. Short, so that it does not exceed the file system's limit on names.
fs::path name_beside(const fs::path& target) {
  static std::atomic<unsigned> count{0};
  return target.parent_path() / fmt::format(".atelier-{}-{}.part", ::getpid(), count++);
}

bool is_name_beside(const std::string& name) {
  return name.starts_with(".atelier-") && name.ends_with(".part");
}

/// Writes all of `bytes`, in as many calls as needed. On an error returns false with errno set.
bool write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes.remove_prefix(std::size_t(written));
  }
  return true;
}

/// The file that a write to `path` replaces. A symbolic link is resolved, so that the link itself stays.
fs::path replaced_file(const fs::path& path) {
  std::error_code failed;
  const fs::path resolved = fs::is_symlink(path, failed) ? fs::canonical(path, failed) : path;
  return failed || resolved.empty() ? path : resolved;
}

}  // namespace

std::string read_file(const fs::path& path, std::size_t limit) {
  const auto fail = [&](const std::string& reason) -> Error {
    return Error(fmt::format("{}: cannot be read: {}", path.string(), reason));
  };
  // O_NONBLOCK: opening a FIFO without a writer must not block. It has no effect on a regular file.
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
  if (!file) throw fail(system_reason());
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) throw fail(system_reason());
  if (S_ISDIR(status.st_mode)) throw fail("it is a folder, not a file");
  if (!S_ISREG(status.st_mode)) throw fail("it is not a regular file");
  if (std::size_t(status.st_size) > limit)
    throw fail(fmt::format("it has {} bytes; at most {} are allowed", status.st_size, limit));

  // The size is only a hint (files in /proc report 0, and a file may grow), so read to the end.
  std::string bytes(std::size_t(status.st_size) + 1, '\0');
  std::size_t length = 0;
  while (true) {
    if (length == bytes.size()) bytes.resize(2 * length + 4096);
    const ssize_t got = ::read(file.get(), bytes.data() + length, bytes.size() - length);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw fail(system_reason());
    if (got == 0) break;
    length += std::size_t(got);
    if (length > limit) throw fail(fmt::format("it has more than the {} bytes allowed", limit));
  }
  bytes.resize(length);
  return bytes;
}

void write_file(const fs::path& path, std::string_view bytes) {
  const auto fail = [&](const std::string& reason) -> Error {
    return Error(fmt::format("{}: cannot be written: {}", path.string(), reason));
  };
  std::error_code failed;
  if (path.has_parent_path()) fs::create_directories(path.parent_path(), failed);
  if (failed) throw fail("its folder cannot be created: " + failed.message());

  const fs::path target = replaced_file(path);
  struct stat old {};
  const bool exists = ::stat(target.c_str(), &old) == 0;
  if (exists && S_ISDIR(old.st_mode)) throw fail("it is a folder");
  // A rename would replace a device such as /dev/null with a file.
  if (exists && !S_ISREG(old.st_mode)) throw fail("it is not a regular file");

  fs::path part;
  Descriptor file;
  do {  // skip files that a killed process with our process number has left
    part = name_beside(target);
    file = Descriptor(::open(part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  } while (!file && errno == EEXIST);
  if (!file) throw fail(system_reason());
  if (exists) (void)!::fchmod(file.get(), old.st_mode & 07777);  // keep the permissions
  // Each call can fail on a full disk; network file systems report it only at close.
  if (!write_all(file.get(), bytes) || !file.reset() || ::rename(part.c_str(), target.c_str()) != 0) {
    const std::string reason = system_reason();
    ::unlink(part.c_str());
    throw fail(reason);
  }
}

void write_file(const fs::path& path, std::span<const std::byte> bytes) {
  write_file(path, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

void remove_unfinished_files(const fs::path& folder) {
  std::error_code ignored;
  std::vector<fs::path> unfinished;
  for (fs::directory_iterator entry(folder, ignored), end; !ignored && entry != end; entry.increment(ignored))
    if (is_name_beside(entry->path().filename().string())) unfinished.push_back(entry->path());
  for (const fs::path& file : unfinished) fs::remove(file, ignored);
}

void require_space(const fs::path& folder, std::uintmax_t bytes) {
  std::error_code unknown;
  const fs::space_info space = fs::space(folder, unknown);
  if (!unknown && space.available < bytes)
    throw Error(fmt::format("{}: the disk is full: {:.1f} MB are free and {:.1f} MB are needed; free some space",
                            folder.string(), double(space.available) / 1e6, double(bytes) / 1e6));
}

std::filesystem::path free_path(const std::filesystem::path& path, const std::string& ending) {
  std::filesystem::path free = path.string() + ending;
  for (int number = 2; std::filesystem::exists(std::filesystem::symlink_status(free)); ++number)
    free = path.string() + ending + "-" + std::to_string(number);
  return free;
}

fs::path temporary_parent() {
  std::error_code failed;
  fs::path parent = fs::temp_directory_path(failed);
  if (failed)
    throw Error("the temporary folder named by TMPDIR is missing (" + failed.message() + "): set TMPDIR to a folder");
  return parent;
}

TemporaryFolder::TemporaryFolder(std::string_view prefix) {
  const fs::path parent = temporary_parent();
  std::string name = (parent / fmt::format("{}-XXXXXX", prefix)).string();
  if (::mkdtemp(name.data()) == nullptr)
    throw Error(fmt::format("{}: cannot create a temporary folder there: {}", parent.string(), system_reason()));
  folder_.emplace(name);
}

TemporaryFolder::TemporaryFolder(TemporaryFolder&& other) noexcept : folder_(std::exchange(other.folder_, {})) {}

TemporaryFolder::~TemporaryFolder() {
  if (!folder_) return;
  folder_->remove_contents();
  std::remove(folder_->path().c_str());  // the empty folder, or the link that is at its place
}

}  // namespace atelier
