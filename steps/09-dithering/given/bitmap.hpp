// BMP files of one bit a pixel, with the student's function. Given.
#pragma once

#include <filesystem>

#include "image/image.hpp"

namespace atelier {

/// Writes a picture that has only black and white pixels to a .bmp file; returns false for other pictures and files.
/// Throws Error if the file cannot be written.
bool write_bitmap(const std::filesystem::path& file, const Image& picture);

}  // namespace atelier
