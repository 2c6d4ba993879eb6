// The gate: checks before any comparison. A picture that fails one of them gets no points and a reason.
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
  std::string sentence;  ///< what is wrong
  std::string hint;      ///< what to try next
  double count = 0;      ///< of pixels that are not finite
};

/// The first check that a picture fails: a size other than the reference's; a NaN or an infinity (names the first ten
/// positions); a single colour although no reference is. Nothing if the picture can be compared.
std::optional<GateFailure> find_gate_failure(const Image& yours, const std::vector<Image>& references,
                                             const JudgedCase& c);

/// The picture with magenta instead of values that are not finite, for reports.
Image mark_non_finite(Image picture);

}  // namespace atelier::judge
