// Partial credit: what an answer that does not pass is worth.
#pragma once

#include <string>

namespace atelier::judge {

/// What is known about a failing picture.
struct Shortfall {
  double share = 1;            ///< f: of the picture that fails, 0..1, by the weights of the case's regions
  double budget_share = 0;     ///< f0: of pixels that may fail, 0..1; 0 counts as one pixel of a 256x256 picture
  double skeleton_share = 1;   ///< f1: of pixels that the untouched skeleton fails, 0..1
  bool blob = false;           ///< failing pixels touch each other and fill at least 3x3
  bool whole_picture = false;  ///< one simple operation on the whole picture (a flip, a shift, a gain ...) explains it
  bool weighted = false;       ///< the case has regions that count more or less than others
};

struct Credit {
  double fraction = 0;      ///< of the case's points, 0..1
  std::string explanation;  ///< how it came about, for the student who asks; empty for 0
};

inline constexpr double largest_skeleton_share = 0.25;
inline constexpr double most_with_blob = 0.70;
inline constexpr double most_with_whole_picture = 0.40;

/// 1 - log10(1 + f/f0) / log10(1 + f1/f0), between 0 and 1, with f1 at most a quarter.
///
/// A logarithm, because shares span five decades: from a few stray pixels to a third of the picture, every factor of
/// ten costs about the same. It reaches 0 at f1, what the untouched skeleton fails, so that a background which was
/// right before the student began earns nothing; and at a quarter of the picture at the latest, because a picture of
/// which so much is wrong shows no working function. Then two caps: `most_with_blob` where wrong pixels form a solid
/// area, which is never mere noise, and `most_with_whole_picture` where one operation explains all, since then one line
/// is wrong and the share says nothing.
Credit partial_credit(const Shortfall& shortfall);

/// Of a probe: the share of inputs answered right, beyond what the skeleton gets right, at most `most_with_blob`, since
/// a function that is wrong somewhere is wrong. `inputs` > 0, 0 < `wrong` <= `inputs`.
Credit partial_probe_credit(int wrong, int inputs, double skeleton_share);

}  // namespace atelier::judge
