#include "base/csv.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"

namespace atelier {
namespace {

/// Takes fields and rows from the front of a text.
class CsvParser {
 public:
  CsvParser(std::string_view text, const std::string& where) : text_(text), where_(where) {
    if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
    const std::string_view first = text_.substr(0, text_.find('\n'));
    if (first.find(';') != first.npos && first.find(',') == first.npos) separator_ = ';';
  }

  std::vector<CsvRow> rows() {
    std::vector<CsvRow> rows;
    while (!text_.empty()) {
      CsvRow row{.line = line_, .fields = {}};
      do row.fields.push_back(field());
      while (skip(separator_));
      const bool returned = skip('\r');
      if (skip('\n') || returned) ++line_;
      if (row.fields.size() > 1 || !row.fields[0].empty()) rows.push_back(std::move(row));
    }
    return rows;
  }

 private:
  bool skip(char c) {
    if (!text_.starts_with(c)) return false;
    text_.remove_prefix(1);
    return true;
  }

  std::string field() {
    if (skip('"')) return quoted();
    const std::size_t end = std::min(text_.size(), text_.find_first_of(std::string("\r\n") + separator_));
    const std::string field(text_.substr(0, end));
    text_.remove_prefix(end);
    return field;
  }

  std::string quoted() {
    const int begin = line_;
    std::string field;
    for (;;) {
      const std::size_t end = text_.find('"');
      if (end == text_.npos) throw Error(fmt::format("{}:{}: a quote is not closed", where_, begin));
      line_ += int(std::count(text_.begin(), text_.begin() + std::ptrdiff_t(end), '\n'));
      field += text_.substr(0, end);
      text_.remove_prefix(end + 1);
      if (!skip('"')) break;
      field += '"';
    }
    if (!text_.empty() && text_[0] != separator_ && text_[0] != '\r' && text_[0] != '\n')
      throw Error(fmt::format("{}:{}: text follows a closed quote; write a quote inside a field twice", where_, line_));
    return field;
  }

  std::string_view text_;
  const std::string& where_;
  char separator_ = ',';
  int line_ = 1;
};

}  // namespace

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

std::vector<CsvRow> parse_csv(std::string_view text, const std::string& where) {
  return CsvParser(text, where).rows();
}

}  // namespace atelier
