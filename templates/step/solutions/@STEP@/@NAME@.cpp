#include "@STEP@/@NAME@.hpp"

#include <algorithm>

namespace atelier::@NAME@ {

float density(float half_distance) {
  // >>> student: the density of fog that lets half of the light through
  if (!(half_distance > 0)) throw std::invalid_argument("density: half_distance must be above 0");
  return 0.693147181f / std::max(half_distance, 1e-6f);
  // --- skeleton
  // | return 0;
  // <<< student
}

}  // namespace atelier::@NAME@
