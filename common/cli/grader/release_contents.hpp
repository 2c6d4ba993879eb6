// What students get: the project without what they are to find out, from an explicit list.
//
//   atelier, CMakeLists.txt, CMakePresets.json, LICENSE, .clang-format, .editorconfig, .gitignore
//   README.md                 handouts/README-release.md
//   cmake/, common/           sources, headers, shaders
//   steps/                    the list of the course; the contracts and programs of the steps, and of those they use
//   skeletons/                the students' files of those steps, cut from the solutions (skeleton_update.hpp)
//   tests/cases/NN-name/      the cases that are not hidden, with their references, sidecars, atlas and hints
//   tests/mistakes/NN-name/   names and sentences of the mistakes, which verdicts say
//   handouts/                 those of these steps, with their pictures
//   solutions/                only what `Earlier` asks for
//   release.sha256            a line for every other file, as `sha256sum -c` reads them
//
// Where the project is a git working tree, what git does not know in cmake/, common/ and steps/ stays behind.
#pragma once

#include <string>
#include <vector>

#include "cli/layout.hpp"
#include "grade/zip.hpp"

namespace atelier {

/// What stands behind an earlier step that a released one uses and that is not itself released.
enum class Earlier {
  none,     ///< the student's own: its skeleton comes along
  source,   ///< its solution
  library,  ///< its solution compiled for machines like this one; its shaders, which have no compiled form, as text
};

struct Release {
  grade::PackedFiles files;
  std::vector<std::string> earlier;    ///< the steps that come along only because others use them
  int cases = 0;                       ///< that come along
  double points = 0;                   ///< of those
  int hidden = 0;                      ///< cases left out
  double hidden_points = 0;            ///< of those
  int solutions = 0, patches = 0;      ///< files left out
  std::vector<std::string> untracked;  ///< files left out because git does not know them
};

/// The release of `steps`. Throws Error where a file of the list is missing or broken, where a solution has not been
/// built and its library is asked for, where a step has only hidden cases, and where a packed file holds a line of a
/// solution (release_leaks.hpp).
Release make_release(const ProjectFolders& folders, const std::vector<CourseStep>& course,
                     const std::vector<CourseStep>& steps, Earlier earlier);

}  // namespace atelier
