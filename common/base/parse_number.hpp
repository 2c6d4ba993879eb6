// Converts a whole text to a number.
#pragma once

#include <charconv>
#include <string_view>

namespace atelier {

/// Reads all of `text` as one decimal Number into `number`; false if it is not one. A leading plus sign is allowed. The
/// locale does not matter. "nan" and "inf" are accepted as floating-point numbers: callers check the range.
template <class Number>
bool parse_number(std::string_view text, Number& number) {
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size();
}

}  // namespace atelier
