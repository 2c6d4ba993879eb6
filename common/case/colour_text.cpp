#include "case/colour_text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/parse_number.hpp"
#include "image/colour.hpp"

namespace atelier {
namespace {

/// "#3380ff"
std::optional<Colour> from_codes(std::string_view text) {
  if (text.size() != 7) return {};
  Colour colour;
  for (int i : {0, 1, 2}) {
    const char* const digits = text.data() + 1 + 2 * i;
    unsigned code = 0;
    if (std::from_chars(digits, digits + 2, code, 16).ptr != digits + 2) return {};
    colour[i] = srgb_decode(code / 255.0);
  }
  return colour;
}

}  // namespace

std::optional<Colour> parse_colour(std::string_view text) {
  if (text.starts_with('#')) return from_codes(text);
  Colour colour;
  for (int i : {0, 1, 2}) {
    const std::size_t end = i < 2 ? text.find(',') : text.size();
    if (end == text.npos || !parse_number(text.substr(0, end), colour[i]) || !std::isfinite(colour[i])) return {};
    if (i < 2) text.remove_prefix(end + 1);
  }
  return colour;
}

std::string colour_text(const Colour& colour) {
  return fmt::format("{},{},{}", colour.r, colour.g, colour.b);
}

}  // namespace atelier
