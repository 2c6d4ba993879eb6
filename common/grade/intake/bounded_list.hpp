// Lists of sentences whose length strangers decide.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace atelier::grade {

/// Keeps the first entries, each once and at most `most`, which is at least 1; if there were more, the last one says
/// how many: "81 more".
void shorten_list(std::vector<std::string>& entries, std::size_t most);

}  // namespace atelier::grade
