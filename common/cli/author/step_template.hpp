// Generates a new step: the files of templates/step/ with the step's names filled in.
//
// Paths below templates/step/ correspond to paths below the project's root. Placeholders in paths and texts:
//   @STEP@ 13-old-film   @NUMBER@ 13   @NAME@ old_film   @TYPE@ OldFilm   @TITLE@ Old film
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace atelier {

/// The names of a step that does not exist yet.
struct StepNames {
  std::string step;    ///< "13-old-film"
  std::string number;  ///< "13"
  std::string name;    ///< "old_film": of files and the namespace, and a prefix of given names
  std::string type;    ///< "OldFilm": prefix of classes
  std::string title;   ///< "Old film"
};

/// The names of the step `text`; if `title` is empty, it is derived from the name. Throws Error, saying what is
/// allowed, if `text` is not NN-name, the name is reserved, the number is below 03 (the template uses steps 01 and 02),
/// or the title is too long or has characters that CMake, JSON or a table cannot hold.
StepNames names_of_step(const std::string& text, const std::string& title);

/// The text with all placeholders filled in. Throws Error naming `where` for an unknown one.
std::string filled_in(const std::string& text, const StepNames& names, const std::string& where);

/// Files by path from the project's root.
using StepFiles = std::map<std::string, std::string>;

/// The step's files, from the templates in `folder`. Throws Error if there are none.
StepFiles files_of_step(const std::filesystem::path& folder, const StepNames& names);

/// Throws Error, naming the path and what to do, if the number, the name or one of the files exists in the project at
/// `root`, or if another new step is not committed yet.
void refuse_taken(const std::filesystem::path& root, const StepNames& names, const StepFiles& files);

/// Writes all files below `root`, or none if one cannot be written.
void write_step(const std::filesystem::path& root, const StepFiles& files);

}  // namespace atelier
