#include "cli/author/edits.hpp"

#include <algorithm>
#include <utility>

#include "base/shuffle.hpp"

namespace atelier {
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
  std::vector<Edit> taken;
  for (const std::size_t i : shuffled_order(edits.size(), seed)) {
    Edit& edit = edits[i];
    const bool free = std::none_of(taken.begin(), taken.end(),
                                   [&](const Edit& other) { return edit.begin < other.end && other.begin < edit.end; });
    if (free && taken.size() < count) taken.push_back(std::move(edit));
  }
  return taken;
}

}  // namespace atelier
