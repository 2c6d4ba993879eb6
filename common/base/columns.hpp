// Text in columns of a terminal. Each code point counts as one column; the project prints no wide characters.
#pragma once

#include <string>
#include <string_view>

namespace atelier {

/// How many columns a printable text takes.
int columns(std::string_view text);

/// The text, filled with spaces up to `width` columns. A longer text is unchanged.
std::string padded(std::string text, int width);

/// The beginning of a text, at most `width` columns; "..." marks a cut.
std::string fitted(std::string_view text, int width);

/// Wraps words into lines of at most `width` columns and indents all lines but the first. A longer word gets its own
/// line.
std::string wrapped(std::string_view text, int width, int indent);

/// Puts `indent` before every line; each line ends with a newline.
std::string indented(std::string_view text, std::string_view indent);

}  // namespace atelier
