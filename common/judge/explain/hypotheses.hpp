// Whole-picture hypotheses: one simple operation that turns a failing picture into the right one.
//
// A picture that is mirrored or encoded twice differs nearly everywhere, and every known mistake looks near to it. So
// these are tried first: undo the operation, and see whether the difference goes away.
#pragma once

#include <optional>
#include <string>

#include "image/compare.hpp"
#include "image/image.hpp"
#include "judge/compare/judged_case.hpp"

namespace atelier::judge {

struct Hypothesis {
  std::string name;      ///< "flipped-y", "shifted", "swapped-channels", "encoded-twice", "gain" ...
  std::string sentence;  ///< what was seen, for a student
  std::string hint;      ///< where to look first
  int over = 0;          ///< of a picture: pixels that still fail when the operation is undone
};

/// A failing picture and its reference, of the same size and finite: as they came, and as they were compared.
struct Failing {
  const Image& yours_raw;
  const Image& reference_raw;
  const Image& yours;
  const Image& reference;
  const JudgedCase& c;
  const Mask& over;  ///< the pixels that fail as it stands
};

/// An operation explains a picture when undoing it leaves at most a tenth of its failing pixels: edges drawn the other
/// way round are rasterised a little differently, so none at all is too much to ask for, and a picture that is mostly
/// symmetric loses fewer than that by chance.
inline constexpr double explained_share = 0.1;

/// The operation that leaves the fewest failing pixels, or none. Tried are: mirrored left to right, top to bottom,
/// both, transposed; shifted by one pixel in eight directions; colour: channels permuted, encoded twice or not at all,
/// a gain between 1/20 and 20; directions: an axis or all negated, n/2 + 1/2 missing or applied twice; data: 1 - v, 2v
/// - 1 or v/2 + 1/2 in place of v, a gain.
std::optional<Hypothesis> explain_whole_picture(const Failing& failing);

}  // namespace atelier::judge
