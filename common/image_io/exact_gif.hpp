// Animations whose frames have at most 256 colours each, stored exactly. Part of the module (module.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "image_io/module.hpp"

namespace atelier::image_io {

struct IndexedFrame {
  int width = 0, height = 0;
  std::vector<std::array<std::uint8_t, 3>> palette;  ///< at most 256
  std::vector<std::uint8_t> indices;                 ///< by pixel
};

/// A frame of 8-bit RGB by its colours; none if there are more than 256.
std::optional<IndexedFrame> indexed(const Samples& samples);

/// The RGB frame again.
Samples samples_of(const IndexedFrame& frame);

/// A GIF that loops forever; `delay` in hundredths of a second. Throws Error with giflib's reason.
std::vector<std::byte> encode_exact_gif(const std::vector<IndexedFrame>& frames, int delay);

}  // namespace atelier::image_io
