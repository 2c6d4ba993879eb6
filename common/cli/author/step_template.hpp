// A new step as text: the files of templates/step/ with the step's names filled in.
//
// The paths below templates/step/ are those below the project's root. In paths and texts alike stand
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
  std::string name;    ///< "old_film": of files, of the namespace, and what given names begin with
  std::string type;    ///< "OldFilm": what classes begin with
  std::string title;   ///< "Old film"
};

/// The names of the step that `text` means; its title is made of the name where `title` is empty. Throws Error, saying
/// what is allowed, where `text` is not NN-name, where the name is a word of C++ or GLSL, where the number is one that
/// the template builds on (00 to 02), and for a title that is too long or that CMake, JSON or a table cannot hold.
StepNames names_of_step(const std::string& text, const std::string& title);

/// The text with all placeholders filled in. Throws Error naming `where` for one that is unknown.
std::string filled_in(const std::string& text, const StepNames& names, const std::string& where);

/// Files by their path from the project's root.
using StepFiles = std::map<std::string, std::string>;

/// The step's files, from the templates in `folder`. Throws Error where there are none.
StepFiles files_of_step(const std::filesystem::path& folder, const StepNames& names);

/// Throws Error, naming the path and what to do, where the number, the name or one of the files is taken in the project
/// at `root`, and where another step has been begun and not been committed.
void refuse_taken(const std::filesystem::path& root, const StepNames& names, const StepFiles& files);

/// Writes all files below `root` or, where one cannot be written, none.
void write_step(const std::filesystem::path& root, const StepFiles& files);

}  // namespace atelier
