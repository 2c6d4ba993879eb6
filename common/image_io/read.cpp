// Reading: the file's format, whether it is complete, and the encoding of its numbers.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/module.hpp"
#include "image_io/extension.hpp"
#include "image_io/image_io.hpp"
#include "image_io/module.hpp"
#include "image_io/whole.hpp"

namespace atelier {
namespace {

using image_io::Samples;

/// A format's first bytes and OpenImageIO's name of it.
struct FormatMark {
  std::string_view mark, name;
};
constexpr FormatMark format_marks[] = {
    {"\x89PNG\r\n\x1a\n", "png"},
    {"\xff\xd8\xff", "jpeg"},
    {"\x76\x2f\x31\x01", "openexr"},
    {"#?RADIANCE", "hdr"},
    {"#?RGBE", "hdr"},
    {"BM", "bmp"},
    {"GIF87a", "gif"},
    {"GIF89a", "gif"},
    {{"II*\0", 4}, "tiff"},
    {{"MM\0*", 4}, "tiff"},
};

std::string format_of(std::string_view bytes, const std::string& name) {
  for (const FormatMark& format : format_marks)
    if (bytes.starts_with(format.mark)) return std::string(format.name);
  if (bytes.starts_with("RIFF") && bytes.substr(std::min<std::size_t>(bytes.size(), 8)).starts_with("WEBP"))
    return "webp";
  if (image_io::lower_extension(name) == ".tga") return "targa";
  throw Error(bytes.empty() ? "it is empty"
                            : "it is not a PNG, JPEG, OpenEXR, HDR, BMP, GIF, TIFF, WebP or Targa (.tga) picture");
}

Image to_image(const Samples& samples) {
  Image image(samples.width, samples.height);
  const float* v = samples.values.data();
  for (Rgba& pixel : image.pixels()) {
    switch (samples.channels) {
      case 1:
        pixel = {v[0], v[0], v[0], 1};
        break;
      case 2:
        pixel = {v[0], v[0], v[0], v[1]};
        break;
      case 3:
        pixel = {v[0], v[1], v[2], 1};
        break;
      default:
        pixel = {v[0], v[1], v[2], v[3]};
        break;
    }
    v += samples.channels;
  }
  return image;
}

/// srgb_decode of 8-bit samples: there are only 256 of them.
void decode_bytes(Image& image) {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> t{};
    for (std::size_t i = 0; i < t.size(); ++i) t[i] = float(srgb_decode(double(i) / 255));
    return t;
  }();
  const auto decode = [&](float v) { return table[std::size_t(std::lround(std::clamp(v, 0.0f, 1.0f) * 255))]; };
  for (Rgba& p : image.pixels()) p = {decode(p.r), decode(p.g), decode(p.b), p.a};
}

Image convert(Image image, Samples::Type stored, Encoding wanted) {
  const bool integers = stored == Samples::Type::bits8 || stored == Samples::Type::bits16;
  if (wanted == Encoding::linear && stored == Samples::Type::bits8) {
    decode_bytes(image);
    return image;
  }
  if (wanted == Encoding::linear && integers) return srgb_decode(image);
  if (wanted == Encoding::srgb && !integers) return srgb_encode(image);
  return image;
}

}  // namespace

Image read_image_bytes(std::span<const std::byte> bytes, const std::string& name, Encoding wanted) try {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const std::string format = format_of(text, name);
  image_io::check_is_whole(format, text);
  static const auto* module =
      static_cast<const image_io::Module*>(module_symbol(image_io::module_name, image_io::module_table));
  const Samples samples = module->decode(bytes, format, {Image::max_side, max_read_pixels});
  return convert(to_image(samples), samples.type, wanted);
} catch (const std::bad_alloc&) {
  throw Error(fmt::format("The picture '{}' cannot be read: there is not enough memory for it.", name));
} catch (const Error& error) {
  throw Error(fmt::format("The picture '{}' cannot be read: {}.", name, error.what()));
}

Image read_image(const std::filesystem::path& path, Encoding wanted) {
  const std::string bytes = read_file(path);
  return read_image_bytes(std::as_bytes(std::span(bytes)), path.string(), wanted);
}

}  // namespace atelier
