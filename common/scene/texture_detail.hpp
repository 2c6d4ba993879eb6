// Shared by textures, reliefs and skies. Not for other code.
#pragma once

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"

namespace atelier::texture_detail {

/// Throws Error "TEXTURE: NAME VALUE (allowed: LOW..HIGH)".
inline void require(const char* texture, const char* name, double value, double low, double high) {
  if (!(value >= low && value <= high))
    throw Error(fmt::format("{}: {} {} (allowed: {}..{})", texture, name, value, low, high));
}

/// 0 below `low`, 1 above `high`, a smooth step in between.
inline double ramp(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

}  // namespace atelier::texture_detail
