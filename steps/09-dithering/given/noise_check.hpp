// Whether ranks are those of void and cluster, whichever of equal cells was taken. Given.
#pragma once

#include <span>
#include <vector>

namespace atelier {

/// How far ranks are from the contract of blue_noise. Energies are those of the contract.
struct NoiseCheck {
  int not_once = 0;      ///< ranks 0 .. size^2 - 1 that no cell or several cells have
  double relaxed = 0;    ///< step 1: by how much the energy falls if the tightest cluster moves to the largest void
  double taken = 0;      ///< step 2: by how much the tightest cluster exceeds the point that was taken, at most
  double added = 0;      ///< step 3: by how much the cell that got a point exceeds the largest void, at most
  int points_moved = 0;  ///< of the `points` lowest ranks, how many are not on a cell of `first`
};

/// Only `not_once` is set if a rank is missing. Throws Error if there are not size^2 ranks.
NoiseCheck check_noise(std::span<const int> ranks, int size, std::span<const int> first);

}  // namespace atelier
