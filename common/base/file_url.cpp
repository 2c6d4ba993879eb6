#include "base/file_url.hpp"

#include <fmt/format.h>

#include <string_view>

namespace atelier {

std::string file_url(const std::filesystem::path& path) {
  constexpr std::string_view kept_marks = "-._~/";
  std::string url = "file://";
  for (const char c : path.string()) {
    const bool kept = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                      kept_marks.find(c) != kept_marks.npos;
    url += kept ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return url;
}

}  // namespace atelier
