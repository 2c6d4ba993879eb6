// Pictures from files and into files.
//
// Behind these functions stands OpenImageIO, in a module of its own that is loaded at the first call: a program that
// never touches a picture file does not pay for it. Colour conversion is ours (image/colour.hpp), not the library's.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "image/colour.hpp"
#include "image/image.hpp"

namespace atelier {

/// Largest picture that is read: Image::max_side a side, and so many pixels (4 GB of floats).
inline constexpr std::size_t max_read_pixels = 256'000'000;

/// Reads a PNG, JPEG, OpenEXR, Radiance HDR, BMP, GIF (its first frame), TIFF, WebP or Targa picture. What it is shows
/// in its first bytes, not in its name, except for Targa (.tga), which has no mark.
///
/// Integer files are taken to hold sRGB, float files linear colour. `wanted` says what comes back:
///   linear  colours proportional to light (integer files are decoded)
///   srgb    encoded colours (float files are encoded; values outside 0..1 stay outside)
///   data    the stored numbers as they are, integers divided by their largest value: normals, masks, depth
/// One channel becomes three equal ones, a missing opacity is 1, channels beyond four are left out; opacity is not
/// multiplied into the colours of formats that keep it apart (PNG, TGA ...).
///
/// Throws Error, naming the file, where it is missing, unreadable, of another kind, broken, truncated, or too large.
Image read_image(const std::filesystem::path& path, Encoding wanted = Encoding::linear);

/// The same from memory; `name` stands for the file in messages ("model.glb, image 3"), and tells a Targa by its
/// ending.
Image read_image_bytes(std::span<const std::byte> bytes, const std::string& name, Encoding wanted = Encoding::linear);

/// How finely a file stores its numbers.
enum class Depth {
  automatic,  ///< 8 bits for PNG, BMP and GIF, 32-bit floats for EXR
  bits8,      ///< PNG, BMP, GIF
  bits16,     ///< PNG
  half,       ///< EXR
  single,     ///< EXR
};

struct WriteOptions {
  Encoding encoding =
      Encoding::linear;  ///< of the image given. Integer files get sRGB, EXR gets linear; data is stored as is
  Depth depth = Depth::automatic;
};

/// Writes a .png, .exr, .bmp or .gif picture, by the path's ending. Integer files get values clamped to 0..1 and
/// rounded to the nearest step, NaN as 0; EXR keeps everything that its floats can hold. Opacity is stored where a
/// pixel is not opaque (PNG, EXR), and dropped by BMP and GIF. The file is whole or not there; missing parent folders
/// are made. Throws Error naming the file where the ending or the depth is not one of these, or it cannot be written.
void write_image(const std::filesystem::path& path, const Image& image, const WriteOptions& options = {});

/// A PNG as bytes, for reports that embed pictures. Depth as write_image takes it for PNG.
std::vector<std::byte> encode_png(const Image& image, const WriteOptions& options = {});

/// Writes a .gif that repeats for ever: `count` frames (1 or more), frame(0), frame(1) ... asked for one after the
/// other, so that only one is in memory; all of one size. `delay` is in seconds from a frame to the next, 0.02..60,
/// kept in hundredths (viewers slow down what is faster). GIF has 256 colours a frame; ramps are dithered. Throws Error
/// as write_image does.
void write_animation(const std::filesystem::path& path, int count, const std::function<Image(int)>& frame, double delay,
                     Encoding encoding = Encoding::linear);
void write_animation(const std::filesystem::path& path, std::span<const Image> frames, double delay,
                     Encoding encoding = Encoding::linear);

}  // namespace atelier
