// Of many choices, those that are worth having: none other is both cheaper and better.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

namespace atelier::measure {

/// Indices of the points (cost, error) that no other point beats: one that is no worse in both and better in one. From
/// the cheapest to the dearest, so that the error falls along them; of equal points the first. Points that are not
/// finite are never among them.
std::vector<std::size_t> pareto_front(std::span<const glm::dvec2> points);

/// Where more cost begins to buy little: the point of a front (in its order, values above zero) that lies farthest
/// below the chord between its first and its last point, both axes as logarithms, each scaled to 0..1. After V.
/// Satopaa, J. Albrecht, D. Irwin and B. Raghavan: Finding a "Kneedle" in a Haystack, ICDCS Workshops 2011, whose
/// curves are not logarithmic; here a factor counts the same everywhere. An error of 0 counts as a tenth of the
/// smallest other one. The first where none lies below the chord; nothing for no points.
std::optional<std::size_t> knee(std::span<const glm::dvec2> front);

}  // namespace atelier::measure
