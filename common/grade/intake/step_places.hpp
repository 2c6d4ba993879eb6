// Finds the steps in a submission, also where their folders have other names or none.
//
// A folder NN-name/ is the step's. The steps are in the folder nearest to the top that has any. What is missing there
// is looked for by the files that a step lists: in folders with a similar name ("blinn-phong", "02_blinn_phong",
// "Step02", "2"), in any folder that has a file which only this step lists, and so also at the top. Of several places
// the nearest to the top counts; of two equally near, that of the newer version by their names
// (grade/intake/version_names.hpp), and a person must look at it. A copy that differs from the skeleton counts before
// an untouched one, wherever both are.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "grade/intake/source_files.hpp"
#include "judge/run/build.hpp"

namespace atelier::grade {

/// Whether Macs, version control or Visual Studio make a folder of this name, beside what a student has written:
/// __MACOSX, .git, .vs.
bool is_folder_of_tools(const std::string& name);

/// Whether systems and compilers leave a file of this path behind: .DS_Store, Thumbs.db, ._move.cpp, a.obj, a.sln.
bool is_litter(const std::string& path);

/// Whether a folder's or archive's name is like a step's: it has its words, or nothing but its number and a word such
/// as "step".
bool is_like_step(const std::string& name, const std::string& step);

/// Where a step's files are.
struct StepPlace {
  std::string folder;                        ///< relative; empty: the top
  bool exact = false;                        ///< the folder has the step's name and directly in it all of its files
  std::map<std::string, std::string> files;  ///< relative paths by listed name
  bool untouched = false;                    ///< it has files, all as in the skeleton
  bool changed = false;                      ///< it has a usable file that is not as in the skeleton
  std::vector<std::string> elsewhere;  ///< if untouched: other files that could be work on the step; printable paths
};

struct StepPlaces {
  std::string base;                            ///< the folder that holds the folders NN-name; empty: the top, or none
  std::map<std::string, StepPlace> steps;      ///< by step
  std::map<std::string, std::string> skipped;  ///< steps whose folder is unusable: "is a symbolic link ..."
  std::vector<std::string> notes;              ///< where a step is in an unexpected place; printable
  std::vector<std::string> ignored;            ///< files with a listed name that count for no step; printable
  std::vector<std::string> needs_human;        ///< doubts; printable
  std::string two_folders;                     ///< "'hw1' and 'hw2'" if both hold folders of steps, equally near
};

/// A file that is used for a step, compared with the one that students are given.
enum class Against { skeleton, changed, unusable };

/// Compares a file for one of the step's listed names.
using Compare = std::function<Against(const SourceFile& file, const std::string& step, const std::string& listed)>;

/// Without `compare`, no file is known to be untouched.
StepPlaces find_steps(const judge::StepFlags& flags, const SourceFiles& files, const Compare& compare = {});

}  // namespace atelier::grade
