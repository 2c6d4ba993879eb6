#include "cli/merge.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/process.hpp"

namespace atelier {

std::optional<std::string> merged(const std::string& mine, const std::string& before, const std::string& after,
                                  Conflict conflict) {
  const TemporaryFolder folder("atelier-merge");
  write_file(folder.path() / "mine", mine);
  write_file(folder.path() / "before", before);
  write_file(folder.path() / "after", after);
  try {
    std::vector<std::string> command = {"git", "merge-file", "--quiet"};
    if (conflict == Conflict::keep_mine) command.push_back("--ours");
    command.insert(command.end(), {"mine", "before", "after"});
    const Finished git =
        run_process({.arguments = command, .folder = folder.path(), .time_limit = std::chrono::seconds(10)});
    if (!git.ok()) return std::nullopt;
  } catch (const Error&) {
    return std::nullopt;  // git is not installed
  }
  return read_file(folder.path() / "mine");
}

}  // namespace atelier
