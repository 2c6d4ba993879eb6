// The contract of a function that a student writes: where it is, and its text.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "cli/layout.hpp"

namespace atelier {

struct Contract {
  std::filesystem::path file;  ///< relative to the folder of the own work: "steps/02-blinn-phong/blinn_phong.hpp"
  int line = 1;                ///< of the function's head
  std::string text;            ///< the comment above it, and the head
};

/// A C++ function's contract is in the step's header, a GLSL function's above it in the student's file, or, where the
/// student has taken the comment away, in the file as it was handed out. Nothing where none of them has one.
std::optional<Contract> contract_of(const ProjectFolders& folders, const CourseStep& step, const std::string& function);

}  // namespace atelier
