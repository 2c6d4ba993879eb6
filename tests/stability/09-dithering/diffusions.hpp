// Pictures for the rows of diffused and diffused_fast, and diffused errors in double precision.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "09-dithering/dithering.hpp"
#include "stability/random.hpp"
#include "stability/values.hpp"

namespace atelier::stability {

struct Grey {
  int width = 1, height = 1;
  std::vector<float> values;  ///< in rows
};

Grey flat_picture(int width, int height, float value);
/// Each value evenly spread over 0..1.
Grey noise_picture(int width, int height, std::uint64_t seed);
/// Codes of 8 bits on a slope with noise of 16 codes, as values.
Grey slope_picture(int width, int height, std::uint64_t seed);
Grey mirrored(const Grey& picture);

/// The four ways to diffuse errors.
struct DiffusionWay {
  const char* name;
  dithering::Kernel kernel;
  bool serpentine;

  dithering::Diffusion with(int levels) const { return {levels, kernel, serpentine}; }
};
inline constexpr std::array<DiffusionWay, 4> diffusion_ways = {
    {{"Floyd and Steinberg", dithering::Kernel::floyd_steinberg, false},
     {"Floyd and Steinberg, serpentine", dithering::Kernel::floyd_steinberg, true},
     {"Atkinson", dithering::Kernel::atkinson, false},
     {"Atkinson, serpentine", dithering::Kernel::atkinson, true}}};

/// The step's levels, and the same as numbers.
std::vector<std::uint8_t> levels_of(const Grey& picture, const dithering::Diffusion& how);
Values level_numbers(const Grey& picture, const dithering::Diffusion& how);

/// By how much a pixel's level is farther from the sum of its value and the errors than the nearest level, at most over
/// all pixels; in levels, above half a step: a tie costs nothing. The sums are those of the contract in double
/// precision, with the errors that belong to the levels found. So a tie that was decided otherwise changes nothing
/// after it. Infinite if there are more or fewer levels than pixels, or one that is too high.
double level_missed_by(const Grey& picture, const dithering::Diffusion& how, const std::vector<std::uint8_t>& levels);

}  // namespace atelier::stability
