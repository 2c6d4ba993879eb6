#include "base/replace_together.hpp"

#include <system_error>

namespace atelier {

namespace fs = std::filesystem;

void replace_together(const std::vector<Replacement>& replacements) {
  const auto temporary = [](const Replacement& each) { return fs::path(each.target.string() + ".new"); };
  try {
    for (const Replacement& each : replacements) each.write(temporary(each));
    for (const Replacement& each : replacements) fs::rename(temporary(each), each.target);
  } catch (...) {
    std::error_code ignored;
    for (const Replacement& each : replacements) fs::remove(temporary(each), ignored);
    throw;
  }
}

}  // namespace atelier
