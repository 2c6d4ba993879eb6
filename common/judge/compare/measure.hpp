// Compares one picture with one reference, in the unit and by the profile of the case.
#pragma once

#include "image/colour.hpp"
#include "image/compare.hpp"
#include "image/image.hpp"
#include "judge/compare/judged_case.hpp"
#include "judge/compare/result.hpp"

namespace atelier::judge {

inline constexpr double max_shift_strict = 0.05;  ///< pixels by which a whole picture may be shifted
inline constexpr double max_shift_robust = 0.5;

/// The form in which pictures are compared: linear colours after exposure, clamping and sRGB encoding; encoded colours
/// after clamping; both in 0..1 and, for the exact profile, rounded to 8 bits. Directions and data are unchanged.
Image compared_form(const Image& raw, const JudgedCase& c);

bool is_colour(Unit unit);  ///< colours, linear or encoded, as opposed to directions and data

/// The encoding of the pictures that a program writes for this unit.
Encoding encoding_of(Unit unit);

/// The measure of image/compare.hpp for this unit.
Measure measure_of(Unit unit);

/// The number of pixels that may exceed delta: the case's budget, but in pictures below 32x32 at most 1 in 256, since a
/// few pixels are a large part of a small picture.
int effective_budget(const JudgedCase& c, int pixels);

struct Measurement {
  bool passed = false;
  int pixels = 0;               ///< of the picture
  Difference difference;        ///< by the profile; masked pixels never fail
  double failing_fraction = 0;  ///< the failing fraction of the unmasked picture, weighted by regions, 0..1
  Shift shift;                  ///< of the whole picture; 0 for the exact profile, which does not compute it
  bool shifted = false;         ///< by more than the profile's limit
};

/// Compares two finite pictures of the case's size in compared form. `slack` multiplies the case's tolerances (delta,
/// budget, limit of the shift): 1 for judging, 2 to check that a mistake is at least twice the tolerance away. The
/// exact profile has no tolerance, so `slack` has no effect on it.
Measurement measure(const Image& yours, const Image& reference, const JudgedCase& c, double slack = 1);

/// The worst pixel of a measurement, both values in the unit that was compared (0..255 for colours).
Worst worst_pixel(const Measurement& measured, const Image& yours, const Image& reference, Unit unit);

inline constexpr double max_margin = 1024;

/// The distance of `yours` in tolerances: the largest slack at which it still fails, to 1 %, at most `max_margin`;
/// below 1 for a picture that passes, 0 if it would pass with a hundredth of the tolerance.
double margin(const Image& yours, const Image& reference, const JudgedCase& c);

}  // namespace atelier::judge
