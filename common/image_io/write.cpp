// Writing: the format by the path, its encoding and its depth.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/module.hpp"
#include "image_io/extension.hpp"
#include "image_io/image_io.hpp"
#include "image_io/module.hpp"

namespace atelier {
namespace {

using image_io::Samples;
using Type = Samples::Type;

/// What a format can store; the first type is the default.
struct Format {
  std::string_view extension;  // with the dot; the rest is OpenImageIO's name of the format
  std::vector<Type> types;
  bool opacity;
  bool linear;  // stores linear light, not sRGB
};

const Format& format_of(std::string_view extension) {
  static const Format formats[] = {{".png", {Type::bits8, Type::bits16}, true, false},
                                   {".exr", {Type::single, Type::half}, true, true},
                                   {".bmp", {Type::bits8}, false, false},
                                   {".gif", {Type::bits8}, false, false}};
  for (const Format& format : formats)
    if (format.extension == extension) return format;
  throw Error(fmt::format("its name must end in .png, .exr, .bmp or .gif, not in '{}'", extension));
}

Type type_in(const Format& format, Depth depth) {
  if (depth == Depth::automatic) return format.types.front();
  const Type type = depth == Depth::bits8    ? Type::bits8
                    : depth == Depth::bits16 ? Type::bits16
                    : depth == Depth::half   ? Type::half
                                             : Type::single;
  if (std::find(format.types.begin(), format.types.end(), type) == format.types.end())
    throw Error(
        fmt::format("{} pictures do not have this depth (8 bits: PNG, BMP, GIF; 16 bits: PNG; half and single "
                    "floats: EXR)",
                    format.extension.substr(1)));
  return type;
}

/// The pixel in the format's encoding.
Rgba converted(const Rgba& pixel, Encoding encoding, bool to_linear) {
  if (encoding == Encoding::data || (encoding == Encoding::linear) == to_linear) return pixel;
  return to_linear ? srgb_decode(pixel) : srgb_encode(pixel);
}

template <class Integer>
Integer quantise(float value) {
  constexpr float largest = float(Integer(-1));
  return value > 0 ? Integer(std::lround(std::min(value, 1.0f) * largest)) : Integer(0);  // NaN becomes 0
}

Samples to_samples(const Image& image, const Format& format, Type type, Encoding encoding) {
  if (image.empty()) throw Error("it has no pixels");
  const bool opaque = std::all_of(image.pixels().begin(), image.pixels().end(), [](const Rgba& p) { return p.a == 1; });
  Samples samples{image.width(), image.height(), format.opacity && !opaque ? 4 : 3, type};
  const std::size_t count = image.pixels().size() * std::size_t(samples.channels);
  if (type == Type::bits8)
    samples.bytes.reserve(count);
  else if (type == Type::bits16)
    samples.words.reserve(count);
  else
    samples.values.reserve(count);
  samples.srgb = !format.linear && encoding != Encoding::data;
  for (const Rgba& pixel : image.pixels()) {
    const Rgba p = converted(pixel, encoding, format.linear);
    const float values[] = {p.r, p.g, p.b, p.a};
    for (int c = 0; c < samples.channels; ++c) switch (type) {
        case Type::bits8:
          samples.bytes.push_back(quantise<std::uint8_t>(values[c]));
          break;
        case Type::bits16:
          samples.words.push_back(quantise<std::uint16_t>(values[c]));
          break;
        default:
          samples.values.push_back(values[c]);
          break;
      }
  }
  return samples;
}

const image_io::Module& module() {
  static const auto* table =
      static_cast<const image_io::Module*>(module_symbol(image_io::module_name, image_io::module_table));
  return *table;
}

std::vector<std::byte> encode(const Image& image, std::string_view extension, const WriteOptions& options) {
  const Format& format = format_of(extension);
  const Type type = type_in(format, options.depth);
  return module().encode(to_samples(image, format, type, options.encoding), std::string(extension.substr(1)));
}

/// Runs `work`, and adds the file's name to its errors.
template <class Work>
auto naming(const std::string& name, Work work) -> decltype(work()) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    throw Error(fmt::format("The picture '{}' cannot be written: there is not enough memory for it.", name));
  } catch (const Error& error) {
    throw Error(fmt::format("The picture '{}' cannot be written: {}.", name, error.what()));
  }
}

}  // namespace

void write_image(const std::filesystem::path& path, const Image& image, const WriteOptions& options) {
  write_file(path, naming(path.string(), [&] { return encode(image, image_io::lower_extension(path), options); }));
}

std::vector<std::byte> encode_png(const Image& image, const WriteOptions& options) {
  return naming("in memory", [&] { return encode(image, ".png", options); });
}

void write_animation(const std::filesystem::path& path, int count, const std::function<Image(int)>& frame, double delay,
                     Encoding encoding) {
  const auto bytes = naming(path.string(), [&] {
    if (image_io::lower_extension(path) != ".gif") throw Error("the name of an animation must end in .gif");
    if (count < 1) throw Error("an animation has one frame or more");
    if (!(delay >= 0.02 && delay <= 60)) throw Error(fmt::format("a delay of {} s is outside 0.02..60 s", delay));
    int width = 0, height = 0;
    const auto next = [&](int i) {
      const Image image = frame(i);
      if (i == 0) width = image.width(), height = image.height();
      if (image.width() != width || image.height() != height)
        throw Error(fmt::format("its frame {} has {} x {} pixels, the first has {} x {}", i, image.width(),
                                image.height(), width, height));
      return to_samples(image, format_of(".gif"), Type::bits8, encoding);
    };
    return module().animate(count, next, int(std::lround(delay * 100)));
  });
  write_file(path, bytes);
}

void write_animation(const std::filesystem::path& path, std::span<const Image> frames, double delay,
                     Encoding encoding) {
  write_animation(
      path, int(frames.size()), [&](int i) { return frames[std::size_t(i)]; }, delay, encoding);
}

}  // namespace atelier
