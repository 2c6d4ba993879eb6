// Answers all cases of a file for the judge, one after another.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "app/picture.hpp"

namespace atelier {

/// Calls `answer`, which writes its result, for each case of a file. An exception is written to DIR/NAME.build_error,
/// .error or .exception (see case/exchange.hpp) and fails only that case. `progress`, if given, is a file descriptor
/// that gets "begin NAME\n" and "end NAME\n".
void answer_cases(const std::function<void(const Case&)>& answer, const std::filesystem::path& cases,
                  const std::filesystem::path& folder, std::optional<int> progress);

/// Draws pictures and calls probes: writes DIR/NAME.pixels or .values for each case. `stats`: also writes each
/// picture's cost as JSON (app/cost.hpp) to DIR/NAME.stats.
void answer_cases(Painter& painter, const std::filesystem::path& cases, const std::filesystem::path& folder,
                  std::optional<int> progress, bool stats = false);

}  // namespace atelier
