#include "cli/author/edits.hpp"

#include <algorithm>
#include <utility>

namespace atelier {
namespace {

/// SplitMix64 (Steele, Lea, Flood, "Fast splittable pseudorandom number generators", 2014).
std::uint64_t next_random(std::uint64_t& state) {
  std::uint64_t z = state += 0x9e3779b97f4a7c15;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return z ^ (z >> 31);
}

}  // namespace

std::string edited(std::string_view text, std::vector<Edit> edits) {
  std::sort(edits.begin(), edits.end(), [](const Edit& a, const Edit& b) { return a.begin < b.begin; });
  std::string out;
  std::size_t at = 0;
  for (const Edit& edit : edits) {
    out += text.substr(at, edit.begin - at);
    out += edit.text;
    at = edit.end;
  }
  return out.append(text.substr(at));
}

std::vector<Edit> sampled(std::vector<Edit> edits, std::size_t count, std::uint64_t seed) {
  for (std::size_t i = edits.size(); i > 1; --i) std::swap(edits[i - 1], edits[next_random(seed) % i]);
  std::vector<Edit> taken;
  for (Edit& edit : edits) {
    const bool free = std::none_of(taken.begin(), taken.end(),
                                   [&](const Edit& other) { return edit.begin < other.end && other.begin < edit.end; });
    if (free && taken.size() < count) taken.push_back(std::move(edit));
  }
  return taken;
}

}  // namespace atelier
