// The terminal report: what to correct first, and what waits for it.
#pragma once

#include <string>

#include "image/image.hpp"
#include "judge/compare/result.hpp"
#include "judge/report/report_words.hpp"

namespace atelier::judge {

/// What the terminal supports. The default is for a plain file: no escape sequences.
struct TerminalStyle {
  bool colour = false;                       ///< ANSI colours
  bool unicode = false;                      ///< characters beyond ASCII
  int width = 100;                           ///< columns, at least 40
  bool table = false;                        ///< a line per case as well
  bool heat_maps = false;                    ///< show a map of each picture's failing pixels
  std::string report_url;                    ///< the HTML report that case names link to (OSC 8); empty: no links
  StepsInReport steps = StepsInReport::one;  ///< of that report; a report of a whole submission sets it
};

/// The style for a file descriptor and the environment: colour on a terminal unless NO_COLOR (no-color.org) is not
/// empty or TERM is "dumb"; unicode if the locale is UTF-8; the window's width. The caller sets `report_url`, if
/// `can_link`.
TerminalStyle terminal_style(int descriptor);

/// Whether to write OSC 8 hyperlinks: only on a terminal that is not "dumb".
bool can_link(int descriptor);

/// All steps with their failures, then the notes, then the total. All untrusted text is made printable.
std::string terminal_report(const SubmissionResult& result, const TerminalStyle& style);

/// One step: its points, then what to correct, in order: each cause with the case that shows it best and the names of
/// those that wait for it. With style.table also a line per case with status, name, score and reason.
std::string terminal_report(const StepResult& step, const TerminalStyle& style);

/// The same for one step, with the first cause only, and the headlines of the others.
std::string first_cause_report(const StepResult& step, const TerminalStyle& style);

/// Words about the report's place, such as its path: with style.report_url a link to it, at the case to begin with.
std::string report_link(const std::string& words, const SubmissionResult& result, const TerminalStyle& style);

/// The red channel, 0..1, of an error image (a mask of failing pixels, or a FLIP map) as framed text, `columns` wide. A
/// darker character is a larger mean over the cell, relative to the largest mean; even one failing pixel shows as a
/// dot. The number of rows keeps the proportions for characters twice as tall as wide. Empty for an empty image.
std::string ascii_heat_map(const Image& errors, int columns = 48);

}  // namespace atelier::judge
