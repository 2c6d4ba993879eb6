#include "base/utf16.hpp"

namespace atelier {

void append_utf8(std::string& text, char32_t c) {
  const auto trailing = [&](int shift) { text += char(0x80 | ((c >> shift) & 0x3f)); };
  if (c < 0x80) {
    text += char(c);
  } else if (c < 0x800) {
    text += char(0xc0 | (c >> 6));
    trailing(0);
  } else if (c < 0x10000) {
    text += char(0xe0 | (c >> 12));
    trailing(6), trailing(0);
  } else {
    text += char(0xf0 | (c >> 18));
    trailing(12), trailing(6), trailing(0);
  }
}

std::optional<std::string> from_utf16(std::string_view bytes) {
  const bool low_first = bytes.starts_with("\xff\xfe"), high_first = bytes.starts_with("\xfe\xff");
  if ((!low_first && !high_first) || bytes.size() % 2 != 0) return std::nullopt;
  const auto unit = [&](std::size_t i) {
    const auto first = static_cast<unsigned char>(bytes[i]), second = static_cast<unsigned char>(bytes[i + 1]);
    return char32_t(low_first ? first | second << 8 : first << 8 | second);
  };
  const auto is_high = [](char32_t c) { return c >= 0xd800 && c < 0xdc00; };
  const auto is_low = [](char32_t c) { return c >= 0xdc00 && c < 0xe000; };
  std::string text;
  for (std::size_t i = 2; i < bytes.size(); i += 2) {
    char32_t c = unit(i);
    if (is_low(c)) return std::nullopt;
    if (is_high(c)) {
      i += 2;
      if (i >= bytes.size() || !is_low(unit(i))) return std::nullopt;
      c = 0x10000 + ((c - 0xd800) << 10) + (unit(i) - 0xdc00);
    }
    append_utf8(text, c);
  }
  return text;
}

}  // namespace atelier
