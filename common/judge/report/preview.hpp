// A small picture for an editor's preview: yours | reference | difference.
#pragma once

#include <filesystem>

#include "judge/compare/result.hpp"

namespace atelier::judge {

/// Side by side: yours, the reference, the difference as a heat map; encoded. Throws Error if the sizes differ.
Image preview_image(const Evidence& evidence);

/// Writes it as a PNG, shrunk so that no side exceeds `longest` pixels (>= 1). Throws Error naming the file if it
/// cannot be written.
void write_preview(const std::filesystem::path& file, const Evidence& evidence, int longest = Image::max_side);

}  // namespace atelier::judge
