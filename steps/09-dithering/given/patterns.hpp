// The patterns of thresholds that the program uses, as ranks of the student's functions. Given.
#pragma once

#include <vector>

namespace atelier {

/// Different cells of a size x size tile for the first points of blue noise: about a tenth of them, the same ones at
/// each call.
std::vector<int> first_points(int size);

/// Cells of the tile of blue noise along each side.
inline constexpr int blue_noise_size = 64;

}  // namespace atelier
