// Resets a student's file to its skeleton, and keeps a copy of the old file.
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

/// The file for "02/blinn_phong.cpp", "steps/02-blinn-phong/blinn_phong.cpp" (or its absolute path), or
/// "blinn_phong.cpp" if only one step has it. Throws Error listing the candidates if none or several match.
StudentFile find_student_file(const ProjectFolders& folders, const std::vector<CourseStep>& course,
                              const std::string& text);

/// The original file: from .given/NN-name/FILE or skeletons/NN-name/FILE if one exists (as in a release), otherwise
/// generated from solutions/NN-name/FILE. Throws Error if none of the three exists.
std::string pristine_text(const ProjectFolders& folders, const StudentFile& file);

/// Whether the file in steps/ equals that text. Throws as pristine_text does.
bool is_pristine(const ProjectFolders& folders, const StudentFile& file);

struct Reset {
  bool changed = false;        ///< false if the file was already pristine: nothing was written
  std::filesystem::path copy;  ///< of the old file: FILE.before-reset, or with -2, -3 ...; empty without old file
};

/// Overwrites the file in steps/ with the pristine text, after copying the old file to an unused name.
Reset reset_file(const ProjectFolders& folders, const StudentFile& file);

}  // namespace atelier
