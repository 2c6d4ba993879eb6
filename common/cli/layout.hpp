// Where everything stands: the project's folders, and the steps of the course as CMake has told them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace atelier {

/// One step as the build knows it.
struct CourseStep {
  std::string name;                  ///< "02-blinn-phong": its folder below steps/, solutions/, tests/cases/ ...
  std::string title;                 ///< "Light and materials after Blinn and Phong"
  std::vector<std::string> files;    ///< what a student writes; plain names
  std::vector<std::string> headers;  ///< what its C++ may include, as it is included
  std::vector<std::string> uses;     ///< the earlier steps whose functions it calls
  std::string number() const { return name.substr(0, name.find('-')); }  ///< "02"
};

/// The folders of the project, all absolute, and the course in order.
struct ProjectFolders {
  std::filesystem::path root;   ///< where ./atelier lies
  std::filesystem::path build;  ///< build/release, or what ATELIER_BUILD says
  /// Whose work it is: steps/, out/ and progress.json lie here. Empty: the root. The variable ATELIER_WORK names
  /// another folder, for several students with one copy of the project.
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
  /// Of a release alone: the skeletons that it brings, and those that were given to the student (skeleton_update.hpp).
  std::filesystem::path skeletons() const { return root / "skeletons"; }
  std::filesystem::path given() const { return own() / ".given"; }

  std::filesystem::path case_file(const std::string& step) const { return cases() / step / "cases.json"; }
  std::filesystem::path measure_file(const std::string& step) const { return cases() / step / "measure.json"; }
  std::filesystem::path baseline_file(const std::string& step) const { return cases() / step / "baseline.json"; }
  std::filesystem::path hints_file(const std::string& step) const { return cases() / step / "hints.json"; }
  std::filesystem::path mistakes_file(const std::string& step) const { return mistakes() / step / "mistakes.json"; }
  std::filesystem::path variants_file(const std::string& step) const { return variants() / step / "variants.json"; }
  /// Mutants that are known to change nothing (cli/author/mutant_list.hpp).
  std::filesystem::path equivalents_file(const std::string& step) const {
    return root / "tests" / "mutants" / step / "equivalent.json";
  }

  std::filesystem::path program(const std::string& step) const { return build / "bin" / step; }
  std::filesystem::path step_flags() const { return build / "step_flags.json"; }
  /// Compiled step libraries: below "solutions" the finished ones.
  std::filesystem::path implementations() const { return build / "implementations"; }
  /// The student's own, which are nobody else's.
  std::filesystem::path own_implementations() const {
    return work.empty() ? implementations() / "mine" : work / ".implementations";
  }
  /// Decoded reference pictures; may be deleted at any time.
  std::filesystem::path reference_cache() const { return build / "cache" / "references"; }
  std::filesystem::path shader_cache() const { return build / "cache" / "shaders"; }
};

/// The folders that this program was built for. Throws Error where ATELIER_WORK names a folder without steps/.
ProjectFolders project_folders();

/// The steps of a step_flags.json (written by CMake), by name. Throws Error naming the file and the member.
std::vector<CourseStep> read_course(const std::filesystem::path& step_flags);

/// The step meant by "02", "2", "02-blinn-phong" or a part that only one name has, such as "phong". Throws Error, with
/// the steps that there are, for none and for several.
const CourseStep& resolve_step(const std::vector<CourseStep>& course, const std::string& text);

/// The steps meant by `texts`, in the order of the course; all where there is no text. Throws as resolve_step does.
std::vector<CourseStep> resolve_steps(const std::vector<CourseStep>& course, const std::vector<std::string>& texts);

}  // namespace atelier
