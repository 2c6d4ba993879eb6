// Makes what editors of all systems save the text that compilers read: UTF-8 with LF line ends.
#pragma once

#include <string>
#include <string_view>

namespace atelier::grade {

struct ConvertedText {
  std::string text;         ///< UTF-8 with LF; the bytes unchanged if they are no text
  std::string encoding;     ///< "UTF-16", "UTF-8 with a byte-order mark" or "Latin-1"; empty: UTF-8
  std::string line_ends;    ///< "CRLF", "CR"; empty: LF, or no line end
  std::string why_no_text;  ///< "is a PDF, not a text"; empty: it is a text
};

/// Reads UTF-8, UTF-16 (by its byte-order mark, or without one by the zero bytes of its ASCII characters), and what is
/// neither as Latin-1 (ISO 8859-1). Line ends CR LF, also with several CR, become LF; CR alone where no LF is. A NUL
/// that remains, or a beginning as of a PDF, an archive or a picture, makes it no text.
ConvertedText convert_text(std::string_view bytes);

/// Whether two texts are the same but for line ends, byte-order marks, encoding and blanks at the ends of lines and at
/// the end.
bool are_same_text(std::string_view a, std::string_view b);

}  // namespace atelier::grade
