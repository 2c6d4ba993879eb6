#include "09-dithering/given/bitmap.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "09-dithering/dithering.hpp"
#include "base/file.hpp"

namespace atelier {

bool write_bitmap(const std::filesystem::path& file, const Image& picture) {
  const auto is_grey = [](const Rgba& p, float grey) { return p.r == grey && p.g == grey && p.b == grey; };
  if (file.extension() != ".bmp" ||
      !std::ranges::all_of(picture.pixels(), [&](const Rgba& p) { return is_grey(p, 0) || is_grey(p, 1); }))
    return false;
  std::vector<std::uint8_t> bits;
  for (const Rgba& p : picture.pixels()) bits.push_back(p.r > 0.5f);
  const std::vector<std::uint8_t> bytes = dithering::bitmap_file(bits, picture.width());
  write_file(file, std::string(bytes.begin(), bytes.end()));
  return true;
}

}  // namespace atelier
