#include "cli/author/last_bits.hpp"

#include <vector>

#include "cli/author/code_tokens.hpp"
#include "cli/author/edits.hpp"

namespace atelier {
namespace {

/// Moves a float, a vector or a matrix; everything else stays as it is.
constexpr const char* moving_functions = R"(
#include <bit>
#include <cstdint>
#include <glm/glm.hpp>
namespace moved_last_bits {
inline float moved(float x) {
  static std::uint32_t state = SEEDu;
  state = state * 1664525u + 1013904223u;
  if (!(x > 1e-30f || x < -1e-30f) || !(x - x == 0)) return x;  // 0 and what is not finite stay
  return std::bit_cast<float>(std::bit_cast<std::uint32_t>(x) + (state >> 16) % 3u - 1u);
}
template <int L, glm::qualifier Q>
glm::vec<L, float, Q> moved(glm::vec<L, float, Q> v) {
  for (int i = 0; i < L; ++i) v[i] = moved(v[i]);
  return v;
}
template <int C, int R, glm::qualifier Q>
glm::mat<C, R, float, Q> moved(glm::mat<C, R, float, Q> m) {
  for (int i = 0; i < C; ++i) m[i] = moved(m[i]);
  return m;
}
template <class T>
T moved(T other) {
  return other;
}
}  // namespace moved_last_bits
)";

}  // namespace

std::string with_moved_last_bits(std::string_view code, std::uint64_t seed) {
  std::vector<Edit> edits;
  const std::vector<Token> tokens = tokens_of(code);
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (!tokens[i].is("return") || i + 1 >= tokens.size() || tokens[i + 1].is(";") || tokens[i + 1].is("{")) continue;
    const auto end = end_of_statement(tokens, i + 1);
    if (!end) continue;
    edits.push_back({tokens[i + 1].begin, tokens[i + 1].begin, "moved_last_bits::moved(", "moved"});
    edits.push_back({tokens[*end].begin, tokens[*end].begin, ")", "moved"});
  }
  std::string head = moving_functions;
  head.replace(head.find("SEED"), 4, std::to_string(seed % 4294967291u));
  return head + edited(code, edits);
}

}  // namespace atelier
