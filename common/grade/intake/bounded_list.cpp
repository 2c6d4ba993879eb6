#include "grade/intake/bounded_list.hpp"

#include <fmt/format.h>

#include <set>

namespace atelier::grade {

void shorten_list(std::vector<std::string>& entries, std::size_t most) {
  std::set<std::string> seen;
  std::erase_if(entries, [&](const std::string& entry) { return !seen.insert(entry).second; });
  if (entries.size() <= most) return;
  const std::size_t more = entries.size() - (most - 1);
  entries.resize(most - 1);
  entries.push_back(fmt::format("{} more", more));
}

}  // namespace atelier::grade
