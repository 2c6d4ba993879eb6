#include "base/sha256.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace atelier {
namespace {

using Word = std::uint32_t;
__extension__ using Wide = unsigned __int128;

/// floor(x^(1/degree)) for degree 2 or 3 and a root below 2^40, by bisection.
constexpr std::uint64_t integer_root(Wide x, int degree) {
  std::uint64_t low = 0, high = std::uint64_t(1) << 40;
  while (high - low > 1) {
    const std::uint64_t middle = low + (high - low) / 2;
    Wide power = middle;
    for (int i = 1; i < degree; ++i) power *= middle;
    (power <= x ? low : high) = middle;
  }
  return low;
}

/// The standard's constants: the first 32 fractional bits of the square or cube roots of the first primes.
template <std::size_t count>
constexpr std::array<Word, count> fractions_of_roots(int degree) {
  std::array<Word, count> fractions{};
  std::size_t found = 0;
  for (unsigned candidate = 2; found < count; ++candidate) {
    bool prime = true;
    for (unsigned divisor = 2; divisor * divisor <= candidate; ++divisor) prime = prime && candidate % divisor != 0;
    if (prime) fractions[found++] = Word(integer_root(Wide(candidate) << (32 * degree), degree));
  }
  return fractions;
}

constexpr auto initial_state = fractions_of_roots<8>(2);
constexpr auto round_constants = fractions_of_roots<64>(3);
static_assert(initial_state[0] == 0x6a09e667 && round_constants[63] == 0xc67178f2);

/// Processes one 64-byte block: section 6.2.2 of the standard, with its names.
void absorb(std::array<Word, 8>& state, const unsigned char* block) {
  std::array<Word, 64> w;
  for (int t = 0; t < 16; ++t)
    w[t] = Word(block[4 * t]) << 24 | Word(block[4 * t + 1]) << 16 | Word(block[4 * t + 2]) << 8 | block[4 * t + 3];
  for (int t = 16; t < 64; ++t) {
    const Word s0 = std::rotr(w[t - 15], 7) ^ std::rotr(w[t - 15], 18) ^ (w[t - 15] >> 3);
    const Word s1 = std::rotr(w[t - 2], 17) ^ std::rotr(w[t - 2], 19) ^ (w[t - 2] >> 10);
    w[t] = w[t - 16] + s0 + w[t - 7] + s1;
  }
  auto [a, b, c, d, e, f, g, h] = state;
  for (int t = 0; t < 64; ++t) {
    const Word choice = (e & f) ^ (~e & g), majority = (a & b) ^ (a & c) ^ (b & c);
    const Word sum0 = std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22);
    const Word sum1 = std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25);
    const Word first = h + sum1 + choice + round_constants[t] + w[t];
    h = g, g = f, f = e, e = d + first, d = c, c = b, b = a, a = first + sum0 + majority;
  }
  const std::array<Word, 8> mixed{a, b, c, d, e, f, g, h};
  for (int i = 0; i < 8; ++i) state[i] += mixed[i];
}

}  // namespace

std::string sha256(std::string_view bytes) {
  auto state = initial_state;
  const std::size_t whole = bytes.size() / 64 * 64;
  for (std::size_t at = 0; at < whole; at += 64)
    absorb(state, reinterpret_cast<const unsigned char*>(bytes.data()) + at);

  // Padding: the remaining bytes, a one bit, zeros and the length in bits make one or two last blocks.
  std::string tail(bytes.substr(whole));
  tail.push_back(char(0x80));
  tail.resize(tail.size() <= 56 ? 56 : 120, '\0');
  for (int shift = 56; shift >= 0; shift -= 8) tail.push_back(char(std::uint64_t(bytes.size()) * 8 >> shift));
  for (std::size_t at = 0; at < tail.size(); at += 64)
    absorb(state, reinterpret_cast<const unsigned char*>(tail.data()) + at);

  std::string text;
  for (Word word : state)
    for (int shift = 28; shift >= 0; shift -= 4) text.push_back("0123456789abcdef"[word >> shift & 15]);
  return text;
}

}  // namespace atelier
