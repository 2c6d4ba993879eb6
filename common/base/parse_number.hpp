// A number that is the whole of a text.
#pragma once

#include <charconv>
#include <string_view>

namespace atelier {

/// Whether all of `text` is one Number in decimal, which is then in `number`; a plus sign may stand before it. The same
/// in every locale. A real may be "nan" or "inf": ranges refuse them.
template <class Number>
bool parse_number(std::string_view text, Number& number) {
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size();
}

}  // namespace atelier
