#include "judge/compare/gate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "image/compare.hpp"
#include "judge/compare/measure.hpp"
#include "judge/explain/sentences.hpp"

namespace atelier::judge {
namespace {

GateFailure non_finite_failure(const NonFinite& found) {
  std::string positions;
  for (const Position& p : found.first) positions += fmt::format("{}({}, {})", positions.empty() ? "" : ", ", p.x, p.y);
  return {
      GateFailure::Kind::non_finite,
      fmt::format("{} {} NaN or infinity, {} {}.", grouped((long long)found.count),
                  found.count == 1 ? "pixel is" : "pixels are",
                  found.count <= found.first.size() ? "at" : "the first ones at", positions),
      "Look for a division by zero, the square root or a power of a negative number, and normalize(0). Each gives NaN "
      "or infinity, and so does everything computed from it.",
      double(found.count)};
}

GateFailure single_colour_failure(const Image& yours, const JudgedCase& c) {
  const Rgba first = compared_form(yours, c).pixels()[0];
  const bool data = c.unit == Unit::number;
  const std::string what = data
                               ? fmt::format("the same everywhere: ({:.4g}, {:.4g}, {:.4g})", first.r, first.g, first.b)
                               : colour_name(first) + " all over";
  return {GateFailure::Kind::single_colour, fmt::format("The picture is {}.", what),
          "No part of the scene is visible. Is it drawn at all? Check matrices, winding and depth test, and whether "
          "vertices are on the screen. Then: does the shader write what it computes?"};
}

}  // namespace

std::optional<GateFailure> find_gate_failure(const Image& yours, const std::vector<Image>& references,
                                             const JudgedCase& c) {
  const Image& reference = references.front();
  if (!yours.same_size(reference))
    return GateFailure{GateFailure::Kind::size,
                       fmt::format("The picture is {}x{} pixels; the case requires {}x{}.", yours.width(),
                                   yours.height(), reference.width(), reference.height()),
                       "Draw at the required size."};
  if (const NonFinite found = find_non_finite(yours); found.count > 0) return non_finite_failure(found);
  const bool reference_varies =
      std::none_of(references.begin(), references.end(), [](const Image& image) { return is_single_colour(image); });
  if (reference_varies && is_single_colour(yours)) return single_colour_failure(yours, c);
  return std::nullopt;
}

Image mark_non_finite(Image picture) {
  for (Rgba& p : picture.pixels())
    if (!std::isfinite(p.r) || !std::isfinite(p.g) || !std::isfinite(p.b) || !std::isfinite(p.a)) p = {1, 0, 1, 1};
  return picture;
}

}  // namespace atelier::judge
