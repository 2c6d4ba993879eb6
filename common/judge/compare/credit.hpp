// Partial credit: the points for an answer that does not pass.
#pragma once

#include <string>

namespace atelier::judge {

/// What partial credit depends on. All fractions are 0..1.
struct PictureFailure {
  double failing_fraction = 1;   ///< f: of the picture, by the weights of the case's regions
  double budget_fraction = 0;    ///< f0: of pixels that may fail; 0 counts as one pixel of a 256x256 picture
  double skeleton_fraction = 1;  ///< f1: of pixels that the untouched skeleton fails
  bool blob = false;             ///< failing pixels form a solid block of at least 3x3
  bool whole_picture = false;    ///< one simple operation (a flip, a shift, a gain ...) explains the difference
  bool weighted = false;         ///< the case has regions with weights
};

struct Credit {
  double fraction = 0;      ///< of the case's points, 0..1
  std::string explanation;  ///< how it was computed, for the student; empty for 0
};

inline constexpr double max_skeleton_fraction = 0.25;
inline constexpr double max_credit_with_blob = 0.70;
inline constexpr double max_credit_whole_picture = 0.40;

/// 1 - log10(1 + f/f0) / log10(1 + f1/f0), between 0 and 1, with f1 limited to a quarter.
///
/// It is logarithmic because f spans five decades: from a few stray pixels to a third of the picture, every factor of
/// ten costs about the same. It reaches 0 at f1, the untouched skeleton's fraction, so that an already correct
/// background earns nothing; and at a quarter of the picture at the latest, because a picture with more errors shows no
/// working function. Two caps follow: `max_credit_with_blob` if wrong pixels form a solid area, which is never noise,
/// and `max_credit_whole_picture` if one operation explains the difference, since then f says nothing about the error.
Credit partial_credit(const PictureFailure& failure);

/// For a probe: linear in the fraction of wrong inputs, from 1 at none to 0 at the skeleton's fraction; at most
/// `max_credit_with_blob`. `inputs` > 0, 0 < `wrong` <= `inputs`.
Credit partial_probe_credit(int wrong, int inputs, double skeleton_fraction);

}  // namespace atelier::judge
