#include "base/sealed.hpp"

#include <cstdint>

namespace atelier {
namespace {

// The null byte marks the file as not a text: for tools, and for release_leaks.hpp.
constexpr std::string_view mark("Atelier: a sealed part of a solution, for later steps only\n\0", 60);

/// Its own inverse: exclusive-or with a linear congruential sequence (Knuth's MMIX constants).
std::string scrambled(std::string_view bytes) {
  std::string result(bytes);
  std::uint64_t state = 2;
  for (char& byte : result) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    byte = char(std::uint8_t(byte) ^ std::uint8_t(state >> 56));
  }
  return result;
}

}  // namespace

const std::size_t seal_length = mark.size();

std::string seal(std::string_view text) {
  return std::string(mark) + scrambled(text);
}

bool is_sealed(std::string_view bytes) {
  return bytes.starts_with(mark);
}

std::string unsealed(std::string bytes) {
  return is_sealed(bytes) ? scrambled(std::string_view(bytes).substr(mark.size())) : bytes;
}

}  // namespace atelier
