#include "judge/compare/picture_cache.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <system_error>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/sha256.hpp"

namespace atelier::judge {
namespace {

/// The header of an entry, in the machine's byte order, since a cache is not shared between machines.
struct Header {
  std::array<char, 8> magic{'A', 'T', 'L', 'C', 'A', 'C', 'H', '1'};
  std::uint32_t width = 0, height = 0;
  std::uint64_t checksum = 0;
  std::array<char, 64> key{};  ///< identifies the picture and its state
};

/// Detects incomplete and damaged entries at memory speed. It does not detect deliberate changes; SHA-256 on the
/// picture does. Four interleaved FNV-1a hashes, each over every fourth 64-bit word: a single one would wait for the
/// latency of each multiplication.
std::uint64_t checksum(std::span<const Rgba> pixels) {
  constexpr std::uint64_t offset = 0xcbf29ce484222325, prime = 0x100000001b3;
  std::array<std::uint64_t, 4> chain{offset, offset + 1, offset + 2, offset + 3};
  static_assert(sizeof(Rgba) == 16);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    std::uint64_t words[2];
    std::memcpy(words, &pixels[i], sizeof words);
    for (std::size_t k = 0; k < 2; ++k) {
      std::uint64_t& lane = chain[i % 2 * 2 + k];
      lane = (lane ^ words[k]) * prime;
    }
  }
  std::uint64_t folded = offset;
  for (std::uint64_t lane : chain) folded = (folded ^ lane ^ lane >> 32) * prime;
  return folded;
}

std::optional<Image> read_entry(const std::filesystem::path& file, const std::array<char, 64>& key) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) return std::nullopt;
  try {
    const std::string bytes = read_file(file);
    Header header;
    if (bytes.size() < sizeof header) return std::nullopt;
    std::memcpy(&header, bytes.data(), sizeof header);
    const auto side_fits = [](std::uint32_t side) { return side >= 1 && side <= std::uint32_t(Image::max_side); };
    if (header.magic != Header{}.magic || header.key != key) return std::nullopt;
    if (!side_fits(header.width) || !side_fits(header.height)) return std::nullopt;
    if (bytes.size() != sizeof header + std::size_t(header.width) * header.height * sizeof(Rgba)) return std::nullopt;
    Image image(int(header.width), int(header.height));
    std::memcpy(image.pixels().data(), bytes.data() + sizeof header, bytes.size() - sizeof header);
    if (checksum(image.pixels()) != header.checksum) return std::nullopt;
    return image;
  } catch (const Error&) {
    return std::nullopt;  // treat an unreadable entry as missing
  }
}

void write_entry(const std::filesystem::path& file, const std::array<char, 64>& key, const Image& image) {
  Header header;
  header.key = key;
  header.width = std::uint32_t(image.width());
  header.height = std::uint32_t(image.height());
  header.checksum = checksum(image.pixels());
  std::string bytes(sizeof header + image.pixels().size_bytes(), '\0');
  std::memcpy(bytes.data(), &header, sizeof header);
  std::memcpy(bytes.data() + sizeof header, image.pixels().data(), image.pixels().size_bytes());
  try {
    write_file(file, bytes);
  } catch (const Error&) {
    // FailingPicture to write the cache (full disk, read-only home) must not prevent a verdict.
  }
}

}  // namespace

Image cached_picture(const std::filesystem::path& folder, const std::filesystem::path& picture,
                     const std::string& fingerprint, const std::function<Image()>& decode) {
  if (folder.empty()) return decode();
  std::error_code problem;
  const auto size = std::filesystem::file_size(picture, problem);
  if (problem) throw Error(fmt::format("{}: cannot be read: {}", picture.string(), problem.message()));
  const auto changed = std::filesystem::last_write_time(picture, problem);
  if (problem) throw Error(fmt::format("{}: cannot be read: {}", picture.string(), problem.message()));

  // The entry's name depends only on the picture's path, so that a changed picture overwrites its old entry.
  const std::string place = std::filesystem::absolute(picture).lexically_normal().string();
  const std::filesystem::path entry = folder / (sha256(place).substr(0, 32) + ".raw");
  const std::string state =
      sha256(fmt::format("{}\n{}\n{}\n{}", place, size, changed.time_since_epoch().count(), fingerprint));
  std::array<char, 64> key;
  std::copy_n(state.begin(), key.size(), key.begin());
  if (auto kept = read_entry(entry, key)) return std::move(*kept);
  Image image = decode();
  write_entry(entry, key, image);
  return image;
}

}  // namespace atelier::judge
