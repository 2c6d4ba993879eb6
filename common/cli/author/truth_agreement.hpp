// Pictures against the ground truth: what is drawn is what the oracle traces, but for rounding at edges.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "cli/author/workshop.hpp"
#include "image/compare.hpp"
#include "judge/compare/judged_case.hpp"

namespace atelier {

/// Floats place a pixel's middle to about 1e-4 of a pixel, so of the pixels that an edge runs through one in ten
/// thousand falls on its other side, and more where a pattern is seen at a grazing angle. Three times what the worst
/// case shows: the hall at 178 degrees, 59 of 65536.
inline constexpr double share_at_edges = 0.003;

/// Where two edges meet within a pixel, its middle may see what no neighbour's middle sees: so many pixels of a picture
/// may be within no one-pixel shift of the truth. Most show none or one, the seams of fifteen spheres six.
inline constexpr int slivers = 8;

struct Compared {
  Measure measure = Measure::level;
  double delta = 1;    ///< in the measure's unit
  bool linear = true;  ///< linear colour, to be encoded
  double exposure = 1;
};

/// How close a reference must come away from edges. References are half floats: 11 bits.
Compared closeness(const judge::JudgedCase& c);

Image as_compared(Image image, const Compared& how);

/// Whether a step has scenes to trace: step 00 is one line of GLSL and none.
bool has_truth(const CourseStep& step);

/// The step's cases that are pictures.
std::vector<judge::JudgedCase> pictures_of(const ProjectFolders& folders, const CourseStep& step);
std::vector<Case> asks_of(const std::vector<judge::JudgedCase>& cases);

/// These, and of each all that `agreement` needs: which thing, which normal and which depth is seen.
std::vector<Case> with_edges(const std::vector<Case>& asks);

/// The truth of these cases by name, from the step's program; what it refuses is left out. The program loads the
/// version's code, and does not ask it anything. Throws Error with its words where it fails.
std::map<std::string, Image> truths(const Workshop& workshop, const Version& version, const std::vector<Case>& asks,
                                    int samples = 1);

struct Agreement {
  Difference strict, robust;
  int away_from_edges = 0;  ///< pixels that differ though no edge is near
  bool holds() const { return strict.share <= share_at_edges && robust.over <= slivers && away_from_edges == 0; }
};
std::string in_words(const Agreement& a);

/// `drawn` against the truth: each pixel equal to the truth's own, or, near an edge, within what the truth shows one
/// pixel around. `truth` is of the case `name` and of what with_edges adds to it.
Agreement agreement(const std::string& name, const Image& drawn, const std::map<std::string, Image>& truth,
                    const Compared& how);

}  // namespace atelier
