// File extensions.
#pragma once

#include <filesystem>
#include <string>

namespace atelier::image_io {

/// The extension with its dot, in lower case: ".png" of "A.PNG"; empty if there is none.
inline std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  return extension;
}

}  // namespace atelier::image_io
