// The report that a student reads first: a line a case, then for each failure what to know and what to do.
#pragma once

#include <string>

#include "image/image.hpp"
#include "judge/compare/result.hpp"

namespace atelier::judge {

/// What the reader's terminal can do. The default is a plain file: no escape sequence of any kind.
struct TerminalStyle {
  bool colour = false;     ///< ANSI colours
  bool unicode = false;    ///< marks and lines beyond ASCII
  int width = 100;         ///< columns, at least 40
  bool heat_maps = false;  ///< a map of where each failing picture fails
  std::string report_url;  ///< case names link to their places in the HTML report here (OSC 8); empty: no links
};

/// The style for a file descriptor and the environment: colour on a terminal unless NO_COLOR (no-color.org) is set to
/// anything or TERM is "dumb"; unicode where the locale says UTF-8; the window's width. Links are the caller's to add,
/// with `can_link`.
TerminalStyle terminal_style(int descriptor);

/// Whether OSC-8 hyperlinks make sense: only on a terminal that is not "dumb".
bool can_link(int descriptor);

/// All steps: the tables, then the failures, then what was passed over, then the sum. Everything that came from outside
/// is printable.
std::string terminal_report(const SubmissionResult& result, const TerminalStyle& style);

/// One step: a line a case, with status, name, score and reason; then its failures. Cases without an answer for the
/// same reason are told of together, once.
std::string terminal_report(const StepResult& step, const TerminalStyle& style);

/// The red channel, 0..1, of an error image (a mask of failing pixels, or FLIP's) as text `columns` wide, framed: a
/// darker sign is a larger mean over the cell, relative to the largest, and even one failing pixel shows as a dot. Rows
/// are chosen so that the picture keeps its proportions in letters twice as tall as wide. Empty for an empty image.
std::string ascii_heat_map(const Image& errors, int columns = 48);

}  // namespace atelier::judge
