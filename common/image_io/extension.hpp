// What kind of file a name stands for.
#pragma once

#include <filesystem>
#include <string>

namespace atelier::image_io {

/// The ending with its dot, in small letters: ".png" of "A.PNG"; empty where there is none.
inline std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  return extension;
}

}  // namespace atelier::image_io
