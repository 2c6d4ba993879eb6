// Several files that belong together, replaced so that no reader and no full disk leaves a mixture of old and new.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

namespace atelier {

struct Replacement {
  std::filesystem::path target;
  std::function<void(const std::filesystem::path& beside)> write;  ///< writes what is to stand at the target
};

/// Has all of them written beside their targets, and renames them only then. Where one cannot be written what was
/// written is removed, the targets stay as they were, and what `write` or the file system has thrown goes on.
void replace_together(const std::vector<Replacement>& replacements);

}  // namespace atelier
