// Three-way merge of texts.
#pragma once

#include <optional>
#include <string>

namespace atelier {

enum class Conflict { give_up, keep_mine };

/// `mine` with the changes from `before` to `after`, by git merge-file. Nothing if git is missing, and in a conflict
/// unless `conflict` is keep_mine.
std::optional<std::string> merged(const std::string& mine, const std::string& before, const std::string& after,
                                  Conflict conflict = Conflict::give_up);

}  // namespace atelier
