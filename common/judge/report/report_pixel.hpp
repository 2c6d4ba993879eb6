// The report of one pixel (judge/explain/pixel.hpp), for a terminal and as JSON.
#pragma once

#include <string>

#include "judge/explain/pixel.hpp"
#include "judge/report/report_terminal.hpp"

namespace atelier::judge {

/// A table of the outputs, one a line, and what it means. Colours are linear floats, followed by their sRGB codes
/// 0..255 as they are compared; directions are vectors, whatever code a program writes.
std::string pixel_text(const PixelReport& report, const TerminalStyle& style);

/// For programs: values as the step's program writes them; non-finite numbers are "nan", "inf", "-inf", absent values
/// null.
std::string pixel_json(const PixelReport& report);

}  // namespace atelier::judge
