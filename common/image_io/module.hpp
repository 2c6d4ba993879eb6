// The interface of the module atelier-image-io, used only by read.cpp and write.cpp: bytes to samples and back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace atelier::image_io {

/// Samples in the order of a file: row 0 at the top, channels interleaved, without padding.
struct Samples {
  enum class Type { bits8, bits16, half, single };
  int width = 0, height = 0, channels = 0;
  Type type = Type::single;   ///< when reading: the type in the file; the samples are in `values`
  std::vector<float> values;  ///< when reading, integers divided by their largest value; when writing half or single
  std::vector<std::uint8_t> bytes;   ///< when writing bits8
  std::vector<std::uint16_t> words;  ///< when writing bits16
  bool srgb = false;                 ///< when writing: mark the file as sRGB-encoded
};

struct Limits {
  int side = 0;
  std::size_t pixels = 0;
};

/// All functions throw Error with a reason; the caller adds the file's name. Formats are OpenImageIO's names when
/// reading ("openexr"), a file's extension when writing ("exr").
struct Module {
  /// At most the first four channels of the first picture in the file.
  Samples (*decode)(std::span<const std::byte> file, const std::string& format, const Limits& limits);
  std::vector<std::byte> (*encode)(const Samples& samples, const std::string& format);
  /// A GIF of `count` frames of 8-bit RGB; `delay` in hundredths of a second.
  std::vector<std::byte> (*animate)(int count, const std::function<Samples(int)>& frame, int delay);
};

inline constexpr const char* module_name = "atelier-image-io";
inline constexpr const char* module_table = "atelier_image_io_module";  ///< a `const Module`

}  // namespace atelier::image_io
