// Answers a judge: every case of a file, one after another, each answer whole before the next begins.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "app/picture.hpp"

namespace atelier {

/// Calls `answer`, which writes what it has to say, for each case of a file. What it throws is written to
/// DIR/NAME.build_error, .error or .exception (see case/exchange.hpp), costs that case alone, and the rest go on.
/// `progress`, where given, is a descriptor that gets "begin NAME\n" and "end NAME\n".
void answer_cases(const std::function<void(const Case&)>& answer, const std::filesystem::path& cases,
                  const std::filesystem::path& folder, std::optional<int> progress);

/// Draws or calls: DIR/NAME.pixels or .values for each case. `stats`: beside each picture also what it has cost, as
/// JSON (app/cost.hpp), in DIR/NAME.stats.
void answer_cases(Painter& painter, const std::filesystem::path& cases, const std::filesystem::path& folder,
                  std::optional<int> progress, bool stats = false);

}  // namespace atelier
