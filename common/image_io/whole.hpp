// Finds truncated and damaged files before they are decoded: decoders accept them, or print to stderr.
#pragma once

#include <string_view>

namespace atelier::image_io {

/// Throws Error with a reason that does not name the file. Checks "png" and "jpeg"; the other decoders report a missing
/// end themselves.
void check_is_whole(std::string_view format, std::string_view bytes);

}  // namespace atelier::image_io
