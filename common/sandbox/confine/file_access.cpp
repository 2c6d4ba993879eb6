#include "file_access.hpp"

#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdint>

namespace atelier::confine {
namespace {

/// linux/landlock.h of newer kernels than the headers may be for.
struct Ruleset {
  std::uint64_t files = 0, network = 0, scoped = 0;
};

constexpr std::uint64_t read_rights =
    LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
constexpr std::uint64_t rights_of_files =
    LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_WRITE_FILE;
constexpr std::uint64_t devices = LANDLOCK_ACCESS_FS_MAKE_CHAR | LANDLOCK_ACCESS_FS_MAKE_BLOCK;
constexpr std::uint64_t truncate_right = 1 << 14, network_rights = 3, scopes = 3;

/// The rights that a version of Landlock knows.
std::uint64_t all_rights(long version) {
  std::uint64_t rights = (1 << 13) - 1;  // version 1
  if (version >= 2) rights |= 1 << 13;   // links between folders
  if (version >= 3) rights |= truncate_right;
  return rights;
}

bool allow(int ruleset, const std::string& path, std::uint64_t rights) {
  landlock_path_beneath_attr rule{};
  rule.parent_fd = ::open(path.c_str(), O_PATH | O_CLOEXEC);
  if (rule.parent_fd < 0) return false;
  struct stat status {};
  if (::fstat(rule.parent_fd, &status) == 0 && !S_ISDIR(status.st_mode)) rights &= rights_of_files | truncate_right;
  rule.allowed_access = rights;
  const bool done = ::syscall(SYS_landlock_add_rule, ruleset, LANDLOCK_RULE_PATH_BENEATH, &rule, 0) == 0;
  ::close(rule.parent_fd);
  return done;
}

}  // namespace

bool restrict_files(const std::vector<std::string>& readable, const std::vector<std::string>& writable) {
  const long version = ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
  if (version < 1) return false;
  const std::uint64_t all = all_rights(version);
  const Ruleset wanted{.files = all, .network = version >= 4 ? network_rights : 0, .scoped = version >= 6 ? scopes : 0};
  const std::size_t size = version >= 6 ? 24 : version >= 4 ? 16 : 8;
  const int ruleset = int(::syscall(SYS_landlock_create_ruleset, &wanted, size, 0));
  if (ruleset < 0) return false;
  bool done = true;
  for (const std::string& path : readable) done = done && allow(ruleset, path, all & read_rights);
  for (const std::string& path : writable) done = done && allow(ruleset, path, all & ~devices);
  done = done && ::syscall(SYS_landlock_restrict_self, ruleset, 0) == 0;
  ::close(ruleset);
  return done;
}

}  // namespace atelier::confine
