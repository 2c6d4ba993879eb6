#include "judge/compare/credit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "judge/explain/sentences.hpp"

namespace atelier::judge {

Credit partial_credit(const Shortfall& shortfall) {
  const double f0 = std::max(shortfall.budget_share, 1.0 / (256 * 256));
  const double f1 = std::min(shortfall.skeleton_share, largest_skeleton_share);
  const double f = shortfall.share;
  if (f >= f1) return {};  // also where the skeleton fails nothing: there was nothing to earn

  Credit credit;
  credit.fraction = 1 - std::min(1.0, std::log10(1 + f / f0) / std::log10(1 + f1 / f0));
  credit.explanation =
      fmt::format("{} of the pixels fail{}, which is worth {} (all points at none, none at {}{})", percent(f),
                  shortfall.weighted ? ", some counting more than others" : "", percent(credit.fraction), percent(f1),
                  f1 < shortfall.skeleton_share ? "" : ", what the untouched skeleton fails");
  const auto cap = [&](double most, const char* why) {
    if (credit.fraction <= most) return;
    credit.fraction = most;
    credit.explanation += fmt::format("; at most {} because {}", percent(most), why);
  };
  if (shortfall.blob) cap(most_with_blob, "the failing pixels form a solid area");
  if (shortfall.whole_picture)
    cap(most_with_whole_picture, "one operation on the whole picture explains the difference");
  return credit;
}

Credit partial_probe_credit(int wrong, int inputs, double skeleton_share) {
  const double f = double(wrong) / inputs;
  if (f >= skeleton_share) return {};
  const double fraction = std::min(1 - f / skeleton_share, most_with_blob);
  return {fraction,
          fmt::format("{} of {} inputs are answered right, worth {} beyond what the untouched skeleton answers"
                      " (at most {} unless all are right)",
                      inputs - wrong, inputs, percent(fraction), percent(most_with_blob))};
}

}  // namespace atelier::judge
