// The figures of one picture against one reference, in the unit and by the profile of the case.
#pragma once

#include "image/colour.hpp"
#include "image/compare.hpp"
#include "image/image.hpp"
#include "judge/compare/judged_case.hpp"
#include "judge/compare/result.hpp"

namespace atelier::judge {

inline constexpr double strict_shift_limit = 0.05;  ///< pixels that a whole picture may lie beside its reference
inline constexpr double robust_shift_limit = 0.5;

/// How a picture of this case is compared: colours clamped and sRGB-encoded after the exposure, encoded colours
/// clamped, both 0..1 and, for the exact profile, rounded to 8 bits; directions and data as they are.
Image compared_form(const Image& raw, const JudgedCase& c);

bool is_colour(Unit unit);  ///< colours, linear or encoded, as opposed to directions and data

/// How the numbers of a case's pictures stand for light, as a program writes them.
Encoding encoding_of(Unit unit);

/// What image/compare.hpp calls the unit of a case.
Measure measure_of(Unit unit);

/// Pixels that may be over delta: the case's budget; in pictures below 32x32 at most one of 256, since what is stray in
/// a large picture is a part of a small one.
int effective_budget(const JudgedCase& c, int pixels);

struct Measurement {
  bool passed = false;
  int pixels = 0;         ///< of the picture
  Difference difference;  ///< by the profile; nothing is over where the case has a mask
  double share = 0;       ///< of the picture that fails, 0..1: without what is masked, and regions by their weights
  Shift shift;            ///< of the whole picture; 0 for the exact profile, which does not ask
  bool shifted = false;   ///< farther than the profile's limit
};

/// Compares two pictures of the size that the case asks for, finite, in compared form. `slack` multiplies what the case
/// tolerates (delta, budget, limit of the shift): 1 judges, 2 asks whether a mistake keeps twice the distance that it
/// must. The exact profile tolerates nothing, and twice nothing.
Measurement measure(const Image& yours, const Image& reference, const JudgedCase& c, double slack = 1);

/// The worst pixel of a measurement, both values in the unit that was compared (0..255 for colours).
Worst worst_pixel(const Measurement& measured, const Image& yours, const Image& reference, Unit unit);

inline constexpr double largest_margin = 1024;

/// How many tolerances away `yours` lies: the largest slack at which it still fails, to 1 %, at most `largest_margin`;
/// below 1 for a picture that passes, 0 where it would pass with a hundredth of the tolerance.
double margin(const Image& yours, const Image& reference, const JudgedCase& c);

}  // namespace atelier::judge
