// The project's folders, and the steps of the course as CMake lists them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace atelier {

/// One step of the course.
struct CourseStep {
  std::string name;                  ///< "02-blinn-phong": its folder in steps/, solutions/, tests/cases/ ...
  std::string title;                 ///< "Light and materials after Blinn and Phong"
  std::vector<std::string> files;    ///< what a student writes; names without a folder
  std::vector<std::string> headers;  ///< what its C++ may include, as it is included
  std::vector<std::string> uses;     ///< the earlier steps whose functions it calls
  std::string number() const { return name.substr(0, name.find('-')); }  ///< "02"
};

/// The folders of the project, all absolute.
struct ProjectFolders {
  std::filesystem::path root;   ///< the folder of ./atelier
  std::filesystem::path build;  ///< build/release, or ATELIER_BUILD
  /// The folder of the student's steps/, out/ and progress.json; empty: the root. The variable ATELIER_WORK sets
  /// another folder, so that several students can share one copy of the project.
  std::filesystem::path work{};

  const std::filesystem::path& own() const { return work.empty() ? root : work; }
  std::filesystem::path steps() const { return own() / "steps"; }
  std::filesystem::path solutions() const { return root / "solutions"; }
  std::filesystem::path cases() const { return root / "tests" / "cases"; }
  std::filesystem::path mistakes() const { return root / "tests" / "mistakes"; }
  std::filesystem::path variants() const { return root / "tests" / "variants"; }
  std::filesystem::path handouts() const { return root / "handouts"; }
  std::filesystem::path out() const { return own() / "out"; }
  std::filesystem::path progress() const { return own() / "progress.json"; }  ///< see cli/student/progress_record.hpp
  /// In releases only: the release's skeletons, and those last given to the student (skeleton_update.hpp).
  std::filesystem::path skeletons() const { return root / "skeletons"; }
  std::filesystem::path given() const { return own() / ".given"; }

  std::filesystem::path case_file(const std::string& step) const { return cases() / step / "cases.json"; }
  std::filesystem::path measure_file(const std::string& step) const { return cases() / step / "measure.json"; }
  std::filesystem::path baseline_file(const std::string& step) const { return cases() / step / "baseline.json"; }
  std::filesystem::path ratios_file(const std::string& step) const { return cases() / step / "ratios.json"; }
  std::filesystem::path hints_file(const std::string& step) const { return cases() / step / "hints.json"; }
  std::filesystem::path mistakes_file(const std::string& step) const { return mistakes() / step / "mistakes.json"; }
  std::filesystem::path variants_file(const std::string& step) const { return variants() / step / "variants.json"; }
  /// Mutants that are known to change nothing (cli/author/mutant_list.hpp).
  std::filesystem::path equivalents_file(const std::string& step) const {
    return root / "tests" / "mutants" / step / "equivalent.json";
  }

  std::filesystem::path program(const std::string& step) const { return build / "bin" / step; }
  std::filesystem::path step_flags() const { return build / "step_flags.json"; }
  /// Compiled step libraries; "solutions" in it has those of the solutions.
  std::filesystem::path implementations() const { return build / "implementations"; }
  /// The student's compiled libraries.
  std::filesystem::path own_implementations() const {
    return work.empty() ? implementations() / "mine" : work / ".implementations";
  }
  /// Decoded reference pictures; may be deleted at any time.
  std::filesystem::path reference_cache() const { return build / "cache" / "references"; }
  std::filesystem::path shader_cache() const { return build / "cache" / "shaders"; }
};

/// The folders that this program was built for. Makes steps/ in the folder that ATELIER_WORK names; throws Error if it
/// cannot.
ProjectFolders project_folders();

/// Whether this copy of the project is a release: it has no tests, and of solutions at most what stands in for steps
/// that a student has not passed (cli/grader/release_contents.hpp).
bool is_release();

/// The steps in step_flags.json (written by CMake), sorted by name. Throws Error naming the file and the member.
std::vector<CourseStep> read_course(const std::filesystem::path& step_flags);

/// The step meant by "02", "2", "02-blinn-phong" or a unique part of a name, such as "phong". Throws Error, with
/// possible steps, if there is none or several match.
const CourseStep& resolve_step(const std::vector<CourseStep>& course, const std::string& text);

/// The steps meant by `texts`, in the order of the course; all if `texts` is empty. Throws as resolve_step does.
std::vector<CourseStep> resolve_steps(const std::vector<CourseStep>& course, const std::vector<std::string>& texts);

}  // namespace atelier
