// A step program's answer to one case, before it is judged.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "image/image.hpp"
#include "judge/compare/choice.hpp"

namespace atelier::judge {

/// If `ended` is `normally`, exactly one of `pixels` and `values` is set. Otherwise `ended` says why there is no
/// answer.
struct Answer {
  enum class Ended { normally, missing, crashed, timeout, build_failed };
  Ended ended = Ended::missing;
  std::optional<Image> pixels;
  std::optional<std::vector<Numbers>> values;
  Counts counts;       ///< the cost of drawing the picture, if it was requested
  std::string error;   ///< one sentence from the program or from reading its files; untrusted text
  std::string output;  ///< what the program printed during this case, limited in size; untrusted text
  double seconds = 0;  ///< wall-clock time of this case, for information only
};

}  // namespace atelier::judge
