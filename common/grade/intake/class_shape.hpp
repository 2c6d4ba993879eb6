// Decides by the paths in a folder or an archive whether it is a class, and which of its entries are the students'.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "judge/run/build.hpp"

namespace atelier::grade {

enum class Platform { moodle, canvas, gradescope, github, folders };

std::string to_string(Platform platform);  ///< "moodle" ...

/// An entry of a class's folder, with what its submission may be recognised by.
struct ClassEntry {
  bool is_folder = false;
  bool has_steps = false;          ///< a file that only one step lists, or a folder NN-name/, at any depth
  bool has_archive = false;        ///< it is an archive or contains one
  bool has_document = false;       ///< it is a document (PDF, Office) or contains one
  bool has_repository = false;     ///< .git is in it
  bool has_step_files = false;     ///< a file that only one step lists, also in what compilers make
  bool has_source = false;         ///< source code of any name, not in what compilers make or the course gives
  bool only_texts = true;          ///< nothing is in it, or texts, which may be the platform's
  std::vector<std::string> steps;  ///< the steps of which it has something
  bool may_be_handed_in() const { return has_steps || has_archive || has_document; }
};

using ClassEntries = std::map<std::string, ClassEntry>;  ///< by name

/// The entries of the folder `inner` (empty: the top) of a tree of files, given as relative paths with slashes; those
/// of folders end with a slash. Without what systems leave behind (.DS_Store, __MACOSX/, ._a).
ClassEntries entries_in(const judge::StepFlags& flags, const std::vector<std::string>& paths, const std::string& inner);

struct ClassShape {
  std::string inner;  ///< the folder that the students' entries are in; empty: the top
  Platform platform = Platform::folders;
  ClassEntries entries;
};

/// Nothing if the tree is no class. It is one
/// - if a name is of Moodle or Gradescope, also a single one: nothing else looks like them;
/// - if at least half of the files have names of Canvas, of several students or where no step lies beside them;
/// - if several entries may be students', and any of them has steps or is an archive. No student's are those with names
///   of versions ("v1", "old", "ada (2)" beside "ada"), of parts of one's work ("hw1", "src") or of what the course
///   gives, and those with files of other kinds only, such as pictures; a folder with nothing or only texts may be a
///   student's who has handed in nothing. A folder that holds steps itself is no such class.
/// Behind single folders it is looked for on.
std::optional<ClassShape> find_class(const judge::StepFlags& flags, const std::vector<std::string>& paths);

/// All paths in a folder on the disk, the nearest levels first, at most 200 000, 12 levels deep; links as files. Of
/// folders of tools only their names.
std::vector<std::string> paths_in(const std::filesystem::path& folder);

}  // namespace atelier::grade
