// Reads and writes picture files.
//
// Uses OpenImageIO, in its own module that is loaded at the first call. Colours are converted by image/colour.hpp, not
// by the library.
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

/// Largest picture that is read: Image::max_side per side, and this many pixels (4 GB of floats).
inline constexpr std::size_t max_read_pixels = 256'000'000;

/// Reads a PNG, JPEG, OpenEXR, Radiance HDR, BMP, GIF (its first frame), TIFF, WebP or Targa picture. The format is
/// detected by the first bytes, not by the name, except for Targa (.tga), which has no signature.
///
/// Integer files are assumed to hold sRGB, float files linear colour. `wanted` selects what is returned:
///   linear  colours proportional to light (integer files are decoded)
///   srgb    encoded colours (float files are encoded; values outside 0..1 stay outside)
///   data    the stored numbers as they are, integers divided by their largest value: normals, masks, depth
/// One channel is copied to three, a missing opacity is 1, channels beyond four are ignored; colours of formats with
/// unassociated alpha (PNG, TGA ...) are not multiplied by it.
///
/// Throws Error, naming the file, if it is missing, unreadable, of another format, damaged, truncated, or too large.
Image read_image(const std::filesystem::path& path, Encoding wanted = Encoding::linear);

/// The same from memory; `name` is used in messages ("model.glb, image 3"); its extension identifies Targa.
Image read_image_bytes(std::span<const std::byte> bytes, const std::string& name, Encoding wanted = Encoding::linear);

/// The sample format of a file.
enum class Depth {
  automatic,  ///< 8 bits for PNG, BMP and GIF, 32-bit floats for EXR
  bits8,      ///< PNG, BMP, GIF
  bits16,     ///< PNG
  half,       ///< EXR
  single,     ///< EXR
};

struct WriteOptions {
  Encoding encoding = Encoding::linear;  ///< of the image. Integer files store sRGB, EXR linear; data is unchanged
  Depth depth = Depth::automatic;
};

/// Writes a .png, .exr, .bmp or .gif picture, by the path's extension. Integer files store values clamped to 0..1 and
/// rounded, NaN as 0; EXR keeps all float values. PNG and EXR store opacity if a pixel is not opaque; BMP and GIF drop
/// it. The write is atomic; missing parent folders are created. Throws Error naming the file if the extension or the
/// depth is not supported, or it cannot be written.
void write_image(const std::filesystem::path& path, const Image& image, const WriteOptions& options = {});

/// A PNG as bytes, for reports that embed pictures. Depths as write_image accepts for PNG.
std::vector<std::byte> encode_png(const Image& image, const WriteOptions& options = {});

/// Writes a .gif that loops forever: `count` frames (1 or more), frame(0), frame(1) ..., requested one at a time, so
/// that only one is in memory; all of the same size. `delay` is the time per frame in seconds, 0.02..60, stored in
/// hundredths (viewers slow down shorter delays). Frames of up to 256 colours each are
/// exact; if one has more, all are dithered. Throws Error
/// as write_image does.
void write_animation(const std::filesystem::path& path, int count, const std::function<Image(int)>& frame, double delay,
                     Encoding encoding = Encoding::linear);
void write_animation(const std::filesystem::path& path, std::span<const Image> frames, double delay,
                     Encoding encoding = Encoding::linear);

}  // namespace atelier
