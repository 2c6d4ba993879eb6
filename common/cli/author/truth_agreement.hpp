// Compares drawn pictures with the ground truth: they must be equal except for rounding at edges.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "cli/author/workshop.hpp"
#include "image/compare.hpp"
#include "judge/compare/judged_case.hpp"

namespace atelier {

/// Floats have errors of about 1e-4 pixel, so one in ten thousand edge pixels falls on the other side of its edge, and
/// more for patterns at grazing angles. Three times the worst case: the hall at 178 degrees, 59 of 65536.
inline constexpr double share_at_edges = 0.003;

/// If two edges meet within a pixel, its centre may show something that no neighbour's centre shows. At most this many
/// pixels of a picture may differ from the truth under every one-pixel shift. Most pictures have none or one, the seams
/// of fifteen spheres six.
inline constexpr int slivers = 8;

struct Compared {
  Measure measure = Measure::level;
  double delta = 1;    ///< in the measure's unit
  bool linear = true;  ///< linear colour, to be encoded
  double exposure = 1;
};

/// The tolerance of a reference away from edges. References are half floats: 11 bits.
Compared closeness(const judge::JudgedCase& c);

Image as_compared(Image image, const Compared& how);

/// The step's cases that are pictures.
std::vector<judge::JudgedCase> pictures_of(const ProjectFolders& folders, const CourseStep& step);
std::vector<Case> asks_of(const std::vector<judge::JudgedCase>& cases);

/// These cases, each with the outputs that `agreement` needs: thing, normal and depth.
std::vector<Case> with_edges(const std::vector<Case>& asks);

/// The truth of these cases by name, from the step's program, without those that have none. The program loads the
/// version's code but does not call it. Throws Error with its message if it fails.
std::map<std::string, Image> truths(const Workshop& workshop, const Version& version, const std::vector<Case>& asks,
                                    int samples = 1);

struct Agreement {
  Difference strict, robust;
  int away_from_edges = 0;  ///< pixels that differ without an edge nearby
  bool holds() const { return strict.share <= share_at_edges && robust.over <= slivers && away_from_edges == 0; }
};
std::string in_words(const Agreement& a);

/// Compares `drawn` with the truth: each pixel must equal the truth's pixel or, near an edge, lie in the range of the
/// truth's pixels around it. `truth` is of the case `name` and of what with_edges adds to it.
Agreement agreement(const std::string& name, const Image& drawn, const std::map<std::string, Image>& truth,
                    const Compared& how);

}  // namespace atelier
