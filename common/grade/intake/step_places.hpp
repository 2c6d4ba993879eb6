// Finds the steps in a submission, also where their folders have other names or none.
//
// A folder NN-name/ is the step's. The steps are in the folder nearest to the top that has any. What is missing there
// is looked for by the files that a step lists: in folders with a similar name ("blinn-phong", "02_blinn_phong",
// "Step02", "2"), in any folder that has a file which only this step lists, and so also at the top. Of several places
// the nearest to the top counts; of two equally near, that of the newer version by their names
// (grade/intake/version_names.hpp), and a person must look at it.
#pragma once

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

StepPlaces find_steps(const judge::StepFlags& flags, const SourceFiles& files);

}  // namespace atelier::grade
