// Replaces several files that belong together, so that a failed write leaves no mixture of old and new files.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

namespace atelier {

struct Replacement {
  std::filesystem::path target;
  std::function<void(const std::filesystem::path& temporary)> write;  ///< writes the new content to `temporary`
};

/// Writes all of them to temporary files beside the targets, then renames them. If one cannot be written, removes the
/// temporary files, leaves the targets unchanged and rethrows the exception.
void replace_together(const std::vector<Replacement>& replacements);

}  // namespace atelier
