// Whole-picture hypotheses: one simple operation that turns a failing picture into the right one.
//
// A mirrored or twice encoded picture differs nearly everywhere and cannot be matched with known mistakes. So the judge
// first tests whether undoing a simple operation removes the difference.
#pragma once

#include <optional>
#include <string>

#include "image/compare.hpp"
#include "image/image.hpp"
#include "judge/compare/judged_case.hpp"

namespace atelier::judge {

struct Hypothesis {
  std::string name;      ///< "flipped-y", "shifted", "swapped-channels", "encoded-twice", "gain" ...
  std::string sentence;  ///< what is wrong, for a student
  std::string hint;      ///< what to check first
  int over = 0;          ///< of a picture: pixels that still fail after undoing the operation
};

/// A failing picture and its reference, of the same size and finite: raw, and in compared form.
struct FailingPicture {
  const Image& yours_raw;
  const Image& reference_raw;
  const Image& yours;
  const Image& reference;
  const JudgedCase& c;
  const Mask& over;  ///< the failing pixels
};

/// An operation explains a picture if undoing it leaves at most this fraction of the failing pixels. Not 0, because
/// mirrored edges are rasterised slightly differently; and small enough that a nearly symmetric picture does not match
/// by chance.
inline constexpr double max_unexplained_fraction = 0.1;

/// The operation that leaves the fewest failing pixels, or nothing. Tested are: mirrored left to right, top to bottom,
/// both, transposed; shifted by one pixel in eight directions; for colours: channels permuted, encoded twice or not at
/// all, a gain between 1/20 and 20; for directions: channels permuted, one or all components negated, n/2 + 1/2 missing
/// or applied twice; for data: 1 - v, 2v - 1 or v/2 + 1/2 instead of v, a gain.
std::optional<Hypothesis> explain_whole_picture(const FailingPicture& failing);

}  // namespace atelier::judge
