// Text that somebody else wrote, made safe to show: on a terminal, in a message, in a report.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace atelier {

/// Whether line ends and tabs of a text stay, or are shown like other control characters.
enum class Layout { one_line, keep_lines };

/// Valid UTF-8 in which nothing moves a cursor, rings a bell, changes a colour or reorders text: control characters
/// (C0, DEL, C1), line and paragraph separators, the marks that turn the direction of writing (U+202A to U+202E,
/// U+2066 to U+2069, which can make code read otherwise than it compiles; Boucher and Anderson, "Trojan Source", 2021),
/// noncharacters and bytes that are no UTF-8 each become U+FFFD. With keep_lines, \n and \t stay and \r\n becomes \n.
std::string printable(std::string_view text, Layout layout = Layout::one_line);

/// At most `limit` bytes of UTF-8, cut between characters; what was cut is replaced by "..." within the limit.
std::string shorten(std::string_view text, std::size_t limit);

/// `text` as a shell takes it for one word, in quotes where it must be; empty where it is not printable, for then no
/// report can show it as it is.
std::string shell_word(const std::string& text);

/// One code point from the front of `text`, which must not be empty: its value and length in bytes. What is no valid
/// UTF-8 (overlong, a surrogate, above U+10FFFF, cut off) gives U+FFFD and length 1. (RFC 3629)
struct CodePoint {
  char32_t value;
  std::size_t bytes;
  bool valid;
};
CodePoint first_code_point(std::string_view text);

}  // namespace atelier
