// What tests/hostile looks for, is laid out before a grading and looked at afterwards: secrets to read, files,
// processes and listeners to reach. See tests/hostile/README.md.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "base/descriptor.hpp"
#include "base/file.hpp"
#include "base/process.hpp"

namespace atelier::test {

/// In two pieces in tests/hostile/tools.cpp, too.
inline const std::string hostile_success = std::string("brea") + "ched: ";
inline const std::string honest_mark = "written by the honest one";

/// One at a time on a machine: its places are fixed, since the hostile files name them.
class Canary {
 public:
  Canary();   ///< throws Error if a place is taken
  ~Canary();  ///< removes what is left, and ends what has survived
  Canary(const Canary&) = delete;
  Canary& operator=(const Canary&) = delete;

  const std::string& secret() const { return secret_; }  ///< must be in no result
  const std::string& honest() const { return honest_; }  ///< in the honest files alone

  /// `./atelier grade ARGUMENTS...` with a descriptor and a variable that lead to the secret, and with a temporary
  /// folder of its own.
  Finished grade(const std::vector<std::string>& arguments) const;

  /// A sentence for each thing outside that is not as it was laid out; empty: nothing has been reached, nothing is
  /// left.
  std::vector<std::string> found_changed();

 private:
  /// By their numbers: those that a grading has left behind.
  std::set<pid_t> left_processes() const;

  std::string secret_, honest_, project_before_;
  TemporaryFolder temporary_{"atelier-hostile-test"};
  pid_t process_ = -1;
  Descriptor port_, abstract_, file_;  ///< listening
};

/// All regular files below a folder, with their bytes.
std::vector<std::pair<std::filesystem::path, std::string>> files_with_bytes(const std::filesystem::path& folder);

}  // namespace atelier::test
