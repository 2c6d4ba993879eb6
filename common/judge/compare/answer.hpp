// What came back from a step program for one case, before anyone has an opinion about it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "image/image.hpp"
#include "judge/compare/choice.hpp"

namespace atelier::judge {

/// Exactly one of `pixels` and `values` is there when the program answered; `ended` says why it did not.
struct Answer {
  enum class Ended { normally, missing, crashed, timeout, build_failed };
  Ended ended = Ended::missing;
  std::optional<Image> pixels;
  std::optional<std::vector<Numbers>> values;
  Counts counts;       ///< of a picture that was to be counted: what drawing it has cost
  std::string error;   ///< one sentence: what the program or the reader of its files objected to; untrusted text
  std::string output;  ///< what the program printed around this case, bounded; untrusted text
  double seconds = 0;  ///< wall clock of this case, for information only
};

}  // namespace atelier::judge
