#include "judge/compare/credit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "judge/explain/sentences.hpp"

namespace atelier::judge {

Credit partial_credit(const PictureFailure& failure) {
  const double f0 = std::max(failure.budget_fraction, 1.0 / (256 * 256));
  const double f1 = std::min(failure.skeleton_fraction, max_skeleton_fraction);
  const double f = failure.failing_fraction;
  if (f >= f1) return {};  // also if the skeleton fails no pixel, so that there is nothing to earn

  Credit credit;
  credit.fraction = 1 - std::min(1.0, std::log10(1 + f / f0) / std::log10(1 + f1 / f0));
  credit.explanation =
      fmt::format("{} of the pixels fail{}: {} of the points (all if none fail, none from {}{})", percent(f),
                  failure.weighted ? " (some count more than others)" : "", percent(credit.fraction), percent(f1),
                  f1 < failure.skeleton_fraction ? "" : ", as for the untouched skeleton");
  const auto cap = [&](double most, const char* why) {
    if (credit.fraction <= most) return;
    credit.fraction = most;
    credit.explanation += fmt::format("; at most {} because {}", percent(most), why);
  };
  if (failure.blob) cap(max_credit_with_blob, "the failing pixels form a solid area");
  if (failure.whole_picture)
    cap(max_credit_whole_picture, "one operation on the whole picture explains the difference");
  return credit;
}

Credit partial_probe_credit(int wrong, int inputs, double skeleton_fraction) {
  const double f = double(wrong) / inputs;
  if (f >= skeleton_fraction) return {};
  const double fraction = std::min(1 - f / skeleton_fraction, max_credit_with_blob);
  return {fraction,
          fmt::format("{} of {} inputs have the right result, which is worth {} of the points: only results that the "
                      "untouched skeleton gets wrong count (at most {} unless all are right)",
                      inputs - wrong, inputs, percent(fraction), percent(max_credit_with_blob))};
}

}  // namespace atelier::judge
