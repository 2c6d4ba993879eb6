// Is all of a file there? Decoders are lenient, or talkative on stderr: what is truncated or damaged is found before.
#pragma once

#include <string_view>

namespace atelier::image_io {

/// Throws Error with a reason that does not name the file. Looks at "png" and "jpeg"; the other decoders say by
/// themselves that an end is missing.
void check_is_whole(std::string_view format, std::string_view bytes);

}  // namespace atelier::image_io
