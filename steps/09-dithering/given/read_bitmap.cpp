#include "09-dithering/given/read_bitmap.hpp"

#include <cstddef>

namespace atelier {

namespace {

/// Little-endian; -1 if the file ends before.
std::int64_t number_at(std::span<const std::uint8_t> file, std::size_t at, std::size_t bytes) {
  if (at + bytes > file.size()) return -1;
  std::int64_t number = 0;
  for (std::size_t i = 0; i < bytes; ++i) number += std::int64_t(file[at + i]) << (8 * i);
  return number;
}

}  // namespace

Bitmap read_bitmap(std::span<const std::uint8_t> file) {
  const auto number = [&](std::size_t at, std::size_t bytes) { return int(number_at(file, at, bytes)); };
  Bitmap bitmap{.is_bitmap = number(0, 2) == 'B' + 256 * 'M',
                .file_size = number(2, 4),
                .pixels_at = number(10, 4),
                .header_size = number(14, 4),
                .width = number(18, 4),
                .height = number(22, 4),
                .planes = number(26, 2),
                .bits = number(28, 2),
                .compression = number(30, 4),
                .colours = number(46, 4)};
  for (std::size_t i = 0; i < 2; ++i)
    bitmap.palette.push_back(std::uint32_t(number_at(file, 54 + 4 * i, 4)) & 0xffffff);
  const std::int64_t width = bitmap.width, height = bitmap.height, row_bytes = (width + 31) / 32 * 4;
  if (width < 1 || height < 1 || bitmap.pixels_at < 0 ||
      bitmap.pixels_at + height * row_bytes > std::int64_t(file.size()))
    return bitmap;
  bitmap.padded_with_zeros = true;
  for (std::int64_t y = height - 1; y >= 0; --y) {
    const auto row = file.subspan(std::size_t(bitmap.pixels_at + y * row_bytes), std::size_t(row_bytes));
    for (std::int64_t x = 0; x < 8 * row_bytes; ++x) {
      const auto bit = std::uint8_t(row[std::size_t(x / 8)] >> (7 - x % 8) & 1);
      if (x < width)
        bitmap.pixels.push_back(bit);
      else
        bitmap.padded_with_zeros = bitmap.padded_with_zeros && bit == 0;
    }
  }
  return bitmap;
}

}  // namespace atelier
