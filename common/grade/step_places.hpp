// Finds misplaced steps in a submission: students often zip one folder too many or too few.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "judge/run/build.hpp"

namespace atelier::grade {

/// Whether Macs or version control make a folder of this name, beside what a student has written: __MACOSX, .git.
bool is_folder_of_tools(const std::string& name);

/// The contents of a folder as relative paths: four levels deep, without following links, at most 10 000 entries.
std::vector<std::string> list_folder(const std::filesystem::path& folder);

/// Whether any of these relative paths of files and folders leads through the folder of a step.
bool has_folders_of_steps(const judge::StepFlags& flags, const std::vector<std::string>& paths);

/// The students' files that are not in a step's folder, each with the step that it belongs to: "move.cpp belongs in
/// 01-move/".
std::vector<std::string> stray_files(const judge::StepFlags& flags, const std::vector<std::string>& paths);

}  // namespace atelier::grade
