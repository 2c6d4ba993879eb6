// Finds the contract of a function that a student writes.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "cli/layout.hpp"

namespace atelier {

struct Contract {
  std::filesystem::path file;  ///< relative to the student's folder: "steps/02-blinn-phong/blinn_phong.hpp"
  int line = 1;                ///< of the function's declaration
  std::string text;            ///< the comment above it, and the declaration
};

/// A C++ function's contract is in the step's header, a GLSL function's above it in the student's file, or, if the
/// student has removed the comment, in the original file. None if no file has one.
std::optional<Contract> contract_of(const ProjectFolders& folders, const CourseStep& step, const std::string& function);

}  // namespace atelier
