// Makes untrusted text safe to show on a terminal, in a message or in a report.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace atelier {

/// Whether line breaks and tabs are kept or replaced like other control characters.
enum class Layout { one_line, keep_lines };

/// Valid UTF-8 without terminal control or reordered text. U+FFFD replaces each control character (C0, DEL, C1), line
/// or paragraph separator, bidirectional control (U+200E, U+200F, U+202A to U+202E, U+2066 to U+2069, which can make
/// source code look different from what is compiled; Boucher and Anderson, "Trojan Source", 2021), noncharacter, and
/// byte that is not valid UTF-8. With keep_lines, \n and \t are kept and \r\n becomes \n.
std::string printable(std::string_view text, Layout layout = Layout::one_line);

/// At most `limit` bytes of UTF-8, cut between characters; "..." marks a cut and counts towards the limit.
std::string shorten(std::string_view text, std::size_t limit);

/// `text` as one word of a shell command, quoted if necessary. Empty if it is not printable, since no report can show
/// it unchanged.
std::string shell_word(const std::string& text);

/// The first code point of `text`, which must not be empty: its value and length in bytes. Invalid UTF-8 (overlong, a
/// surrogate, above U+10FFFF, cut off) gives U+FFFD and length 1 (RFC 3629).
struct CodePoint {
  char32_t value;
  std::size_t bytes;
  bool valid;
};
CodePoint first_code_point(std::string_view text);

}  // namespace atelier
