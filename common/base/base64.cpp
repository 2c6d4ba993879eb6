#include "base/base64.hpp"

#include <algorithm>
#include <string_view>

namespace atelier {

std::string base64(std::span<const std::byte> bytes) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t present = std::min<std::size_t>(3, bytes.size() - i);
    unsigned three = 0;
    for (std::size_t k = 0; k < 3; ++k) three = three << 8 | (k < present ? unsigned(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += k <= present ? letters[three >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

}  // namespace atelier
