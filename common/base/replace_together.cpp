#include "base/replace_together.hpp"

#include <system_error>

namespace atelier {

namespace fs = std::filesystem;

void replace_together(const std::vector<Replacement>& replacements) {
  const auto beside = [](const Replacement& each) { return fs::path(each.target.string() + ".new"); };
  try {
    for (const Replacement& each : replacements) each.write(beside(each));
    for (const Replacement& each : replacements) fs::rename(beside(each), each.target);
  } catch (...) {
    std::error_code ignored;
    for (const Replacement& each : replacements) fs::remove(beside(each), ignored);
    throw;
  }
}

}  // namespace atelier
