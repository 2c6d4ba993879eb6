// Where the steps of a submission are that holds none where they should be: people zip one folder too many, or one too
// few.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "judge/run/build.hpp"

namespace atelier::grade {

/// What lies in a folder, as relative paths: four levels deep, no link followed, at most 10 000 entries.
std::vector<std::string> list_folder(const std::filesystem::path& folder);

/// The folders that hold folders of steps: "" for the top, "hw1/src". `paths` are relative and may be of files or
/// folders.
std::vector<std::string> folders_of_steps(const judge::StepFlags& flags, const std::vector<std::string>& paths);

/// The listed files that lie in no folder of a step, each with the step that it belongs to: "move.cpp belongs in
/// 01-move/".
std::vector<std::string> stray_files(const judge::StepFlags& flags, const std::vector<std::string>& paths);

}  // namespace atelier::grade
