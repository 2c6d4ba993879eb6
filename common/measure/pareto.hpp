// The Pareto front: the choices for which no other is both cheaper and more accurate.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

namespace atelier::measure {

/// Indices of the points (cost, error) that no other point dominates: is no worse in both and better in one. Sorted by
/// rising cost, and so by falling error; of equal points the first. Never includes points that are not finite.
std::vector<std::size_t> pareto_front(std::span<const glm::dvec2> points);

/// The knee, beyond which more cost reduces the error little: the point of a front (in its order, costs above zero)
/// that is farthest below the chord between the first and the last point, on logarithmic axes scaled to 0..1. After V.
/// Satopaa, J. Albrecht, D. Irwin and B. Raghavan: Finding a "Kneedle" in a Haystack, ICDCS Workshops 2011, which uses
/// linear axes. An error of 0 counts as a tenth of the smallest other one. If no point is below the chord, the first;
/// nothing for an empty front.
std::optional<std::size_t> knee(std::span<const glm::dvec2> front);

}  // namespace atelier::measure
