#include "grade/intake/text_conversion.hpp"

#include <optional>
#include <utility>

#include "base/printable.hpp"
#include "base/utf16.hpp"

namespace atelier::grade {
namespace {

constexpr std::string_view utf8_mark = "\xef\xbb\xbf";

/// What a file is that begins like no text; empty if it may be one.
std::string kind_of(std::string_view bytes) {
  const std::pair<std::string_view, const char*> kinds[] = {{"%PDF-", "a PDF"},
                                                            {"PK\x03\x04", "an archive or an Office document"},
                                                            {"Rar!", "an archive"},
                                                            {"7z\xbc\xaf", "an archive"},
                                                            {"\x1f\x8b", "an archive"},
                                                            {"\x89PNG", "a picture"},
                                                            {"\xff\xd8\xff", "a picture"},
                                                            {"\x7f"
                                                             "ELF",
                                                             "a program"},
                                                            {"{\\rtf", "a document in RTF"},
                                                            {"\xd0\xcf\x11\xe0", "an Office document"}};
  for (const auto& [magic, kind] : kinds)
    if (bytes.starts_with(magic)) return kind;
  return "";
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const CodePoint c = first_code_point(text);
    if (!c.valid) return false;
    text.remove_prefix(c.bytes);
  }
  return true;
}

/// UTF-16 with or without its mark. Without one, nearly every second byte of a program's text is zero.
std::optional<std::string> read_utf16(std::string_view bytes) {
  if (std::optional<std::string> text = from_utf16(bytes)) return text;
  if (bytes.size() < 4 || bytes.size() % 2 != 0) return std::nullopt;
  std::size_t zeros[2] = {0, 0};
  for (std::size_t i = 0; i < bytes.size(); ++i) zeros[i % 2] += bytes[i] == '\0';
  const std::size_t units = bytes.size() / 2;
  const auto mostly = [&](int zero, int other) { return zeros[zero] * 10 >= units * 9 && zeros[other] == 0; };
  if (mostly(1, 0)) return from_utf16("\xff\xfe" + std::string(bytes));
  if (mostly(0, 1)) return from_utf16("\xfe\xff" + std::string(bytes));
  return std::nullopt;
}

std::string from_latin1(std::string_view bytes) {
  std::string text;
  for (const char byte : bytes) append_utf8(text, static_cast<unsigned char>(byte));
  return text;
}

/// Makes all line ends LF; returns what they were.
std::string convert_line_ends(std::string& text) {
  if (text.find('\r') == text.npos) return "";
  const bool alone = text.find('\n') == text.npos;
  bool changed = false;
  std::string converted;
  converted.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\r') {
      converted += text[i];
      continue;
    }
    const auto after = text.find_first_not_of('\r', i);
    const bool ends_line = after != text.npos && text[after] == '\n';
    changed |= alone || ends_line;
    if (alone) converted += '\n';
    if (!alone && !ends_line) converted += '\r';
  }
  text = std::move(converted);
  return !changed ? "" : alone ? "CR" : "CRLF";
}

/// Without blanks at the ends of lines and without empty lines at the end.
std::string without_trailing_blanks(std::string_view text) {
  std::string kept;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    const auto last = line.find_last_not_of(" \t\r\f\v");
    if (last != line.npos) kept += line.substr(0, last + 1);
    kept += '\n';
  }
  const auto last = kept.find_last_not_of('\n');
  kept.resize(last == kept.npos ? 0 : last + 1);
  return kept;
}

}  // namespace

ConvertedText convert_text(std::string_view bytes) {
  ConvertedText converted{.text = std::string(bytes), .encoding = {}, .line_ends = {}, .why_no_text = {}};
  if (const std::string kind = kind_of(bytes); !kind.empty()) {
    converted.why_no_text = "is " + kind + ", not a text";
    return converted;
  }
  if (std::optional<std::string> text = read_utf16(bytes)) {
    converted.text = std::move(*text);
    converted.encoding = "UTF-16";
  } else if (bytes.find('\0') != bytes.npos) {
    converted.why_no_text = "has NUL characters and is no text";
    return converted;
  } else if (bytes.starts_with(utf8_mark) && is_utf8(bytes)) {
    converted.text.erase(0, utf8_mark.size());
    converted.encoding = "UTF-8 with a byte-order mark";
  } else if (!is_utf8(bytes)) {
    converted.text = from_latin1(bytes);
    converted.encoding = "Latin-1";
  }
  converted.line_ends = convert_line_ends(converted.text);
  return converted;
}

bool are_same_text(std::string_view a, std::string_view b) {
  return without_trailing_blanks(convert_text(a).text) == without_trailing_blanks(convert_text(b).text);
}

}  // namespace atelier::grade
