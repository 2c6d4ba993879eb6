// UTF-16 texts, as some editors on Windows save them, to UTF-8.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace atelier {

/// Appends a code point, U+0000..U+10FFFF, as UTF-8 (RFC 3629).
void append_utf8(std::string& text, char32_t c);

/// A text that begins with a byte-order mark of UTF-16, of either order, as UTF-8 without one. Nothing if it does not,
/// or is no valid UTF-16: an odd number of bytes, or half of a surrogate pair (RFC 2781).
std::optional<std::string> from_utf16(std::string_view bytes);

}  // namespace atelier
