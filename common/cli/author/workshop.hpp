// Versions of a step's code for author commands: the solution, its skeleton, every known mistake and every variant.
// Each has its own folder below BUILD/audit; libraries are cached there by the hash of their sources.
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
  std::string log;  ///< the compiler's output, or why there is nothing to compile
};

class Workshop {
 public:
  Workshop(const ProjectFolders& folders, const CourseStep& step);

  Version solution() const;
  /// Generated from the solution, since steps/ may have edited files.
  Version skeleton() const;
  /// The solution with a patch. If the patch does not apply, the version is not built and its log says why.
  Version patched(const std::string& name, const std::filesystem::path& patch) const;

  /// The solution with one function as in the skeleton.
  Version without(const std::string& function) const;

  /// The solution with other texts in the place of these files, by their names.
  Version changed(const std::string& name, const std::map<std::string, std::string>& files) const;

  /// Settings to run a version's program: one worker, so that several versions can run in parallel; earlier steps are
  /// the solution's.
  judge::RunSettings settings(const Version& version) const;
  /// The same, with other code behind earlier steps: a version of each, by the step's name.
  judge::RunSettings settings(const Version& version, const std::map<std::string, Version>& earlier) const;

  /// The answers of a version to these cases.
  std::vector<judge::Answer> answers(const Version& version, const std::vector<judge::JudgedCase>& cases) const;

  const CourseStep& step() const { return step_; }

 private:
  /// Builds the version `name` from the files that `write` creates in the folder passed to it.
  Version make(const std::string& name, const std::function<void(const std::filesystem::path&)>& write) const;

  ProjectFolders folders_;
  CourseStep step_;
  judge::StepFlags flags_;
  Owners earlier_;
  std::filesystem::path root_;
};

}  // namespace atelier
