// The contents of a release: the project without solutions and hidden cases, from an explicit list.
//
//   atelier, CMakeLists.txt, CMakePresets.json, LICENSE, .clang-format, .editorconfig, .gitignore
//   README.md                 handouts/README-release.md
//   cmake/, common/           sources, headers, shaders
//   steps/                    the list of the course; contracts and programs of the steps and of the steps they use;
//                             given code that is a second answer only sealed (base/sealed.hpp)
//   skeletons/                the students' files of those steps, cut from the solutions (skeleton_update.hpp)
//   tests/cases/NN-name/      the visible cases with their references, sidecars, atlases and hints
//   tests/mistakes/NN-name/   names and texts of the mistakes, for verdicts
//   handouts/                 those of the steps, with their pictures
//   solutions/                what `Earlier` adds: nothing, sources, or libraries and sealed shaders
//   release.sha256            the hash of every other file, for `sha256sum -c`
//
// In a git working tree, untracked files in cmake/, common/ and steps/ are left out.
#pragma once

#include <string>
#include <vector>

#include "cli/layout.hpp"
#include "grade/zip.hpp"

namespace atelier {

/// What a release has for the earlier steps that its steps use, until a student's own have passed.
enum class Earlier {
  none,     ///< skeletons: the student must solve them first
  source,   ///< of those that are not released themselves, the solution as text
  library,  ///< of all, released or not, the solution in no readable form: compiled, for machines like this one, and
            ///< its shaders sealed
};

struct Release {
  grade::PackedFiles files;
  std::vector<std::string> earlier;    ///< the steps packed only because others use them
  std::vector<std::string> carried;    ///< the steps whose solutions are packed, in any form
  int cases = 0;                       ///< packed cases
  double points = 0;                   ///< of packed cases
  int hidden = 0;                      ///< cases left out
  double hidden_points = 0;            ///< of cases left out
  int solutions = 0, patches = 0;      ///< files left out
  std::vector<std::string> untracked;  ///< files left out because git does not track them
};

/// The release of `steps`. Throws Error if a listed file is missing or broken, a required library has not been built, a
/// step has only hidden cases, or a packed file contains a line of a solution (release_leaks.hpp).
Release make_release(const ProjectFolders& folders, const std::vector<CourseStep>& course,
                     const std::vector<CourseStep>& steps, Earlier earlier);

}  // namespace atelier
