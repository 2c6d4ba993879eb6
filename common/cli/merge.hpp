// Three versions of a text, brought together.
#pragma once

#include <optional>
#include <string>

namespace atelier {

enum class Conflict { give_up, keep_mine };

/// `mine` with what has changed from `before` to `after`, by git merge-file. Nothing where git is missing, and where
/// both have changed the same lines, unless `conflict` says that mine stay.
std::optional<std::string> merged(const std::string& mine, const std::string& before, const std::string& after,
                                  Conflict conflict = Conflict::give_up);

}  // namespace atelier
