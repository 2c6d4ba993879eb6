// Gate 0: pictures that need no comparison. Whatever stops here scores nothing, and says why.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "image/image.hpp"
#include "judge/compare/judged_case.hpp"

namespace atelier::judge {

struct GateFailure {
  enum class Kind { size, non_finite, single_colour };
  Kind kind = Kind::size;
  std::string sentence;  ///< what was seen
  std::string hint;      ///< what to try next
  double count = 0;      ///< of pixels that are not finite
};

/// Stops a picture of another size than the reference's; with a NaN or an infinity anywhere (the first ten positions
/// are named); or of a single colour where no reference is. Nothing where the picture can be compared.
std::optional<GateFailure> stopped_at_gate(const Image& yours, const std::vector<Image>& references,
                                           const JudgedCase& c);

/// The picture with magenta in the place of what is not finite, for people to look at.
Image with_non_finite_marked(Image picture);

}  // namespace atelier::judge
