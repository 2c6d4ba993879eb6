// Diffused errors in double precision, for the truth and the cases. Calls no student's function. Given.
#pragma once

#include <vector>

namespace atelier {

/// The levels of one channel: each pixel collects what its neighbours have left for it, in units of 255ths. Values are
/// 0..1, in rows of `width`.
std::vector<int> exactly_diffused(const std::vector<double>& values, int width, int levels, bool atkinson,
                                  bool serpentine);

}  // namespace atelier
