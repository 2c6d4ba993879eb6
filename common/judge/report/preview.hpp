// One small picture in a fixed place, for an editor's preview: yours | reference | difference.
#pragma once

#include <filesystem>

#include "judge/compare/result.hpp"

namespace atelier::judge {

/// Side by side: yours, the reference, the difference as heat colours; encoded. Throws Error where the two are of
/// different sizes.
Image preview_image(const Evidence& evidence);

/// The same as a PNG. Throws Error naming the file where it cannot be written.
void write_preview(const std::filesystem::path& file, const Evidence& evidence);

}  // namespace atelier::judge
