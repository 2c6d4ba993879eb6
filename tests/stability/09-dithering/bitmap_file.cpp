// bitmap_file: one pixel, rows that end with a word or a pixel after it, long sides.
#include "stability/09-dithering/rows.hpp"

namespace atelier::stability {

using dithering::bitmap_file;

namespace {

/// Half of them black, the others any number but 0.
std::vector<std::uint8_t> random_bits(int width, int height) {
  std::vector<std::uint8_t> bits;
  for (int i = 0; i < width * height; ++i) {
    Trial t(1010, i);
    bits.push_back(t.between(0, 1) < 0.5 ? std::uint8_t(0) : std::uint8_t(t.between(1, 256)));
  }
  return bits;
}

/// The least significant byte first; -1 where the file ends before.
double number_in(const std::vector<std::uint8_t>& file, std::size_t at, std::size_t bytes) {
  if (at + bytes > file.size()) return -1;
  double number = 0;
  for (std::size_t i = bytes; i-- > 0;) number = 256 * number + file[at + i];
  return number;
}

/// What the headers and colours of the file say, in the order of the file; of the colours three bytes each.
Values headers_of(const std::vector<std::uint8_t>& file) {
  return {number_in(file, 0, 2),  number_in(file, 2, 4),  number_in(file, 10, 4), number_in(file, 14, 4),
          number_in(file, 18, 4), number_in(file, 22, 4), number_in(file, 26, 2), number_in(file, 28, 2),
          number_in(file, 30, 4), number_in(file, 54, 3), number_in(file, 58, 3)};
}

Values expected_headers(int width, int height) {
  const double row_bytes = 4 * std::ceil(width / 32.0);
  return {'B' + 256.0 * 'M', 62 + row_bytes * height, 62, 40, double(width), double(height), 1, 1, 0, 0, 0xffffff};
}

/// The size of a file, how many of its pixels are wrong, and how many bits after the pixels of a row are not 0.
Values pixels_of(const std::vector<std::uint8_t>& bits, int width, int height) {
  const std::vector<std::uint8_t> file = bitmap_file(bits, width);
  const std::size_t row_bytes = 4 * ((std::size_t(width) + 31) / 32);
  double wrong = 0, filled = 0;
  for (int y = 0; y < height; ++y)
    for (std::size_t column = 0; column < 8 * row_bytes; ++column) {
      const std::size_t byte = 62 + std::size_t(height - 1 - y) * row_bytes + column / 8;
      const int bit = byte < file.size() ? file[byte] >> (7 - column % 8) & 1 : -1;
      if (column < std::size_t(width))
        wrong += bit != (bits[std::size_t(y) * std::size_t(width) + column] != 0);
      else
        filled += bit != 0;
    }
  return {double(file.size()), wrong, filled};
}

}  // namespace

void add_bitmap_rows(Table& table) {
  Group group = table.of("bitmap_file");
  for (const int width : {0, -1, -32, least_int, 4, 5, 7, largest_int})
    group.refuses(fmt::format("6 pixels, a width of {}", width),
                  [=] { bitmap_file(std::vector<std::uint8_t>(6, 1), width); });
  for (const int width : {1, 0, -1, 32, least_int, largest_int})
    group.refuses(fmt::format("no pixel, a width of {}", width), [=] { bitmap_file({}, width); });
  for (const int value : {0, 1, 2, 127, 128, 255})
    group.equals(fmt::format("one pixel of {}: the bytes of its row", value),
                 [=] {
                   const std::vector<std::uint8_t> file =
                       bitmap_file(std::vector<std::uint8_t>{std::uint8_t(value)}, 1);
                   return Values{double(file.size()), number_in(file, 62, 4)};
                 },
                 {66, value == 0 ? 0.0 : 0x80});
  group.equals("one white pixel in each corner of 33 x 2: the bytes of both rows, the lower one first",
               [] {
                 std::vector<std::uint8_t> bits(66, 0);
                 bits[0] = bits[65] = 1;
                 const std::vector<std::uint8_t> file = bitmap_file(bits, 33);
                 return Values{double(file.size()), number_in(file, 62, 8), number_in(file, 70, 8)};
               },
               {78, 0x80 * 0x1p32, 0x80});
  for (const auto& [width, height] : {std::pair{1, 1},
                                      {7, 3},
                                      {8, 3},
                                      {9, 3},
                                      {31, 2},
                                      {32, 1},
                                      {32, 5},
                                      {33, 1},
                                      {33, 5},
                                      {64, 2},
                                      {65, 2},
                                      {1, 70'000},
                                      {70'000, 1},
                                      {1001, 701}}) {
    const double row_bytes = 4 * std::ceil(width / 32.0);
    group.equals(
        fmt::format("{} x {}: headers and colours", width, height),
        [width = width, height = height] { return headers_of(bitmap_file(random_bits(width, height), width)); },
        expected_headers(width, height));
    group.equals(fmt::format("{} x {}: the file's size, wrong pixels, other bits that are not 0", width, height),
                 [width = width, height = height] { return pixels_of(random_bits(width, height), width, height); },
                 {62 + row_bytes * height, 0, 0});
  }
  group.equals("all white, 33 x 5: wrong pixels, other bits that are not 0",
               [] { return pixels_of(std::vector<std::uint8_t>(33 * 5, 255), 33, 5); }, {102, 0, 0});
}

}  // namespace atelier::stability
