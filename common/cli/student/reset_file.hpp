// A student's file back to the skeleton that it was made from, with a copy of what was there.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/layout.hpp"

namespace atelier {

/// A file that a student writes.
struct StudentFile {
  CourseStep step;
  std::string name;  ///< one of step.files
  std::filesystem::path below_steps() const { return std::filesystem::path(step.name) / name; }
};

/// The file meant by "02/blinn_phong.cpp", "steps/02-blinn-phong/blinn_phong.cpp" (or its absolute path), or
/// "blinn_phong.cpp" where one step alone has it. Throws Error for none and for several, with those there are.
StudentFile find_student_file(const ProjectFolders& folders, const std::vector<CourseStep>& course,
                              const std::string& text);

/// The file as it was handed out: from .given/NN-name/FILE or skeletons/NN-name/FILE where that is there (as in a
/// release), otherwise cut from solutions/NN-name/FILE. Throws Error where none of the three is there.
std::string pristine_text(const ProjectFolders& folders, const StudentFile& file);

/// Whether steps/ has just that text. Throws as pristine_text does.
bool is_pristine(const ProjectFolders& folders, const StudentFile& file);

struct Reset {
  bool changed = false;        ///< false where the file was pristine already: nothing was written
  std::filesystem::path copy;  ///< of what was there: FILE.before-reset, or -2, -3 ... behind; empty where nothing was
};

/// Writes the pristine text over the file in steps/. A copy of what was there is written first, under a name that no
/// file has.
Reset reset_file(const ProjectFolders& folders, const StudentFile& file);

}  // namespace atelier
