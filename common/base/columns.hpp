// Text in columns of a terminal. Each character counts as one column: names and sentences of ours are narrow.
#pragma once

#include <string>
#include <string_view>

namespace atelier {

/// Columns that printable text takes.
int columns(std::string_view text);

/// The text and spaces up to `width` columns; a longer one as it is.
std::string padded(std::string text, int width);

/// The front of a text, at most `width` columns, "..." in place of what is left out.
std::string fitted(std::string_view text, int width);

/// Words in lines of at most `width` columns, further lines indented; a longer word stands alone.
std::string wrapped(std::string_view text, int width, int indent);

/// Every line behind `indent`, and ended.
std::string indented(std::string_view text, std::string_view indent);

}  // namespace atelier
