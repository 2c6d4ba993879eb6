// A small class, and what graders of it have found and left.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/file.hpp"

namespace atelier::test {

/// Six submissions of steps 00 and 01: all points, few, none, with a file that does not compile.
class MadeClass {
 public:
  MadeClass();
  const std::filesystem::path& folder() const { return class_; }
  /// For results, beside the class.
  std::filesystem::path place(const std::string& name) const { return all_.path() / name; }
  /// TMPDIR of the graders; they leave nothing in it.
  const std::filesystem::path& temporary() const { return temporary_; }
  /// A file that a student hands in gets a line more, which changes no points.
  void change(const std::string& student) const;

  /// Control groups that were abandoned before.
  const std::set<std::string>& groups_of_others() const { return groups_of_others_; }

  /// The command `grade CLASS --out OUT --step 00 --step 01 MORE...`.
  std::vector<std::string> command(const std::filesystem::path& out, const std::vector<std::string>& more = {}) const;
  /// The environment of the command.
  std::map<std::string, std::string> environment() const;

  static std::vector<std::string> students();

 private:
  TemporaryFolder all_{"atelier-steps-test"};
  std::filesystem::path class_, temporary_;
  std::set<std::string> groups_of_others_;
};

/// The control groups of processes that have ended. Other tests' graders have some until another one starts.
std::set<std::string> abandoned_groups();

/// What the results of a class say, without times and folders: by file, "students/ada" for points and statuses,
/// "gradebook.csv". Fails the test if a file is missing or is no JSON.
std::map<std::string, std::string> class_verdicts(const std::filesystem::path& out);

/// When and as what a student's report was written; nothing: there is no record.
std::optional<std::string> stamp_of_graded(const std::filesystem::path& out, const std::string& student);

/// What graders have left behind that nobody should find, a sentence each: unfinished files and damaged JSON in `out`,
/// temporary folders, processes, control groups.
std::vector<std::string> leavings(const MadeClass& made, const std::filesystem::path& out);

}  // namespace atelier::test
