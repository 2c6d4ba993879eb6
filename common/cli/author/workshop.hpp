// Versions of a step's code that an author needs beside each other: the solution, the skeleton cut from it, every known
// mistake and every variant. Each has its files in a folder of its own below BUILD/audit; their libraries are kept
// there by what they are compiled from.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "cli/layout.hpp"
#include "cli/search_path.hpp"
#include "grade/step_judge.hpp"
#include "judge/compare/answer.hpp"
#include "judge/run/build.hpp"

namespace atelier {

/// One version, built.
struct Version {
  std::string name;  ///< "mistake-rv-for-nh"
  grade::Code code;
  bool built = false;
  std::string log;  ///< of the compiler, or why there is nothing to compile
};

class Workshop {
 public:
  Workshop(const ProjectFolders& folders, const CourseStep& step);

  Version solution() const;
  /// Cut afresh from the solution: what lies in steps/ may be somebody's work.
  Version skeleton() const;
  /// The solution with a patch. A patch that does not apply gives a version that is not built, and says why.
  Version patched(const std::string& name, const std::filesystem::path& patch) const;

  /// The solution with other texts in the place of these files, by their names.
  Version changed(const std::string& name, const std::map<std::string, std::string>& files) const;

  /// How a version's program is run: one worker, so that several versions can run side by side; earlier steps are the
  /// solution's.
  judge::RunSettings settings(const Version& version) const;
  /// The same, with other code behind earlier steps: a version of each, by the step's name.
  judge::RunSettings settings(const Version& version, const std::map<std::string, Version>& earlier) const;

  /// The answers of a version to these cases.
  std::vector<judge::Answer> answers(const Version& version, const std::vector<judge::JudgedCase>& cases) const;

  const CourseStep& step() const { return step_; }

 private:
  /// The version `name`, of the files that `make` writes into the folder that it is given.
  Version make(const std::string& name, const std::function<void(const std::filesystem::path&)>& write) const;

  ProjectFolders folders_;
  CourseStep step_;
  judge::StepFlags flags_;
  Owners earlier_;
  std::filesystem::path root_;
};

/// Calls task(0) ... task(count - 1) on `threads` threads, each number once. The first exception is thrown again when
/// all have ended.
void for_each_parallel(std::size_t count, int threads, const std::function<void(std::size_t)>& task);

/// As many threads as the machine has cores, at least one.
int worker_threads();

}  // namespace atelier
