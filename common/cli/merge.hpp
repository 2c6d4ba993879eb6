// Three versions of a text, brought together.
#pragma once

#include <optional>
#include <string>

namespace atelier {

/// `mine` with what has changed from `before` to `after`, by git merge-file. Nothing where both have changed the same
/// lines, and where git is missing.
std::optional<std::string> merged(const std::string& mine, const std::string& before, const std::string& after);

}  // namespace atelier
