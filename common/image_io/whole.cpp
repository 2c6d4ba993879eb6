#include "image_io/whole.hpp"

#include <array>
#include <cstdint>

#include "base/error.hpp"

namespace atelier::image_io {
namespace {

std::uint32_t big_endian(std::string_view four) {
  std::uint32_t value = 0;
  for (char c : four) value = value << 8 | std::uint8_t(c);
  return value;
}

/// CRC-32 as PNG uses it (ISO 3309; PNG specification, annex D): the polynomial 0xedb88320, bits reversed.
std::uint32_t crc32(std::string_view bytes) {
  static const std::array<std::uint32_t, 256> table = [] {
    std::array<std::uint32_t, 256> t{};
    for (std::uint32_t i = 0; i < 256; ++i) {
      t[i] = i;
      for (int bit = 0; bit < 8; ++bit) t[i] = t[i] & 1 ? t[i] >> 1 ^ 0xedb88320u : t[i] >> 1;
    }
    return t;
  }();
  std::uint32_t crc = 0xffffffffu;
  for (char c : bytes) crc = crc >> 8 ^ table[(crc ^ std::uint8_t(c)) & 0xff];
  return ~crc;
}

/// A PNG is a signature of eight bytes and then chunks: length, name of four letters, content, checksum of name and
/// content. IEND is the last.
void check_png(std::string_view bytes) {
  constexpr std::size_t mark = 8, around = 12;  // around: bytes of a chunk besides its content
  for (bytes.remove_prefix(mark); bytes.size() >= around;) {
    const std::size_t length = big_endian(bytes.substr(0, 4));
    if (length > bytes.size() - around) break;
    const std::string_view name = bytes.substr(4, 4);
    if (crc32(bytes.substr(4, 4 + length)) != big_endian(bytes.substr(8 + length, 4)))
      throw Error("it is damaged: a checksum does not match");
    if (name == "IEND") return;
    bytes.remove_prefix(around + length);
  }
  throw Error("its end is missing");
}

/// JPEG decoders replace missing data by grey and only warn. The coded pixels after the last start-of-scan marker never
/// contain 0xff 0xd9: that is the end marker, and without it the end is missing.
void check_jpeg(std::string_view bytes) {
  const std::size_t scan = bytes.rfind("\xff\xda");
  if (scan == std::string_view::npos || bytes.find("\xff\xd9", scan) == std::string_view::npos)
    throw Error("its end is missing");
}

}  // namespace

void check_is_whole(std::string_view format, std::string_view bytes) {
  if (format == "png") check_png(bytes);
  if (format == "jpeg") check_jpeg(bytes);
}

}  // namespace atelier::image_io
