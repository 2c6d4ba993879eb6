// Answers a judge: every case of a file, one after another, each answer whole before the next begins.
#pragma once

#include <filesystem>
#include <optional>

#include "app/picture.hpp"

namespace atelier {

/// Writes DIR/NAME.pixels, .values, .build_error, .error or .exception for each case (see case/exchange.hpp). What a
/// student's function throws costs that case alone; the rest go on. `progress`, where given, is a descriptor that gets
/// "begin NAME\n" and "end NAME\n".
void answer_cases(Painter& painter, const std::filesystem::path& cases, const std::filesystem::path& folder,
                  std::optional<int> progress);

}  // namespace atelier
