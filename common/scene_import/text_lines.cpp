#include "scene_import/text_lines.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>

#include "base/error.hpp"

namespace atelier::scene_import {
namespace {

constexpr std::string_view blanks = " \t\r\v\f";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// What Microsoft's C library has long written in place of a number: "1.#INF", "-1.#IND00", "1.#QNAN".
std::optional<float> not_finite(std::string_view text) {
  const std::size_t mark = text.find(".#");
  if (mark == text.npos) return {};
  const std::string_view kind = text.substr(mark + 2);
  if (kind.starts_with("INF")) return text[0] == '-' ? -INFINITY : INFINITY;
  if (kind.starts_with("IND") || kind.starts_with("QNAN") || kind.starts_with("SNAN")) return NAN;
  return {};
}

}  // namespace

TextLines::TextLines(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
    throw Error(fmt::format("{}: the text is UTF-16; save it as UTF-8", name_));
  if (text_.starts_with("\xef\xbb\xbf")) text_.remove_prefix(3);
  if (const std::size_t zero = text_.find('\0'); zero != std::string_view::npos)
    throw Error(fmt::format("{}: not a text file (a zero at byte {})", name_, zero));
}

bool TextLines::next() {
  while (at_ < text_.size()) {
    line_number_ = number_of_lines_ + 1;
    joined_.clear();
    for (bool continued = true; continued && at_ < text_.size();) {
      const std::size_t end = std::min(text_.find_first_of("\n\r", at_), text_.size());
      line_ = text_.substr(at_, end - at_);
      const bool two = text_.substr(std::min(end, text_.size())).starts_with("\r\n");
      at_ = end + (two ? 2 : 1);
      ++number_of_lines_;
      continued = line_.ends_with('\\') && at_ < text_.size();
      if (continued) line_.remove_suffix(1);
      if (continued || !joined_.empty()) {
        joined_ += line_;
        joined_ += ' ';
        line_ = joined_;
      }
    }
    line_ = trimmed(line_);
    if (!line_.empty() && line_[0] != '#') return true;
  }
  return false;
}

std::string_view TextLines::word() {
  if (line_.starts_with('#')) line_ = {};
  const std::size_t end = std::min(line_.find_first_of(blanks), line_.size());
  const std::string_view word = line_.substr(0, end);
  line_ = trimmed(line_.substr(end));
  return word;
}

std::string_view TextLines::rest() {
  return std::exchange(line_, std::string_view());
}

std::optional<float> TextLines::number() {
  const std::string_view text = word();
  if (text.empty()) return {};
  if (const auto value = not_finite(text)) return value;
  std::string_view digits = text;
  if (digits.starts_with('+')) digits.remove_prefix(1);
  // Through double, so that float underflow gives zero and overflow infinity.
  double value = 0;
  const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  // Too large for a double, or too small: from_chars does not say which of the two.
  if (problem == std::errc::result_out_of_range)
    return float(std::strtod(std::string(digits.data(), end).c_str(), nullptr));
  if (problem != std::errc() || end != digits.data() + digits.size())
    fail(fmt::format("'{}' is not a number", text.substr(0, 40)));
  return float(value);
}

void TextLines::fail(const std::string& complaint, int line) const {
  throw Error(fmt::format("{}:{}: {}", name_, line, complaint));
}

}  // namespace atelier::scene_import
