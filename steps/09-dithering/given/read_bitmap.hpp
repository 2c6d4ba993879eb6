// Reads BMP files of one bit a pixel, without the student's code. Given.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace atelier {

/// What a file says. Numbers are -1 where the file ends before them.
struct Bitmap {
  bool is_bitmap = false;  ///< begins with "BM"
  int file_size = -1, pixels_at = -1, header_size = -1, width = -1, height = -1, planes = -1, bits = -1,
      compression = -1, colours = -1;
  std::vector<std::uint32_t> palette;  ///< 0xRRGGBB
  std::vector<std::uint8_t> pixels;    ///< 0 or 1, from the top; empty if the file is too short for them
  bool padded_with_zeros = false;      ///< unused bits and bytes of rows
};

Bitmap read_bitmap(std::span<const std::uint8_t> file);

}  // namespace atelier
