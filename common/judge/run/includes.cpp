#include "judge/run/includes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <set>

#include "base/near_names.hpp"
#include "base/printable.hpp"

namespace atelier::judge {
namespace {

/// For computation, containers and debug output; not for files, threads, processes, clocks or loading libraries.
constexpr std::array allowed_standard_headers = std::to_array<std::string_view>(
    {"algorithm",   "array",         "bit",           "bitset",    "cassert",     "cctype",
     "cerrno",      "cfloat",        "charconv",      "cinttypes", "climits",     "cmath",
     "compare",     "complex",       "concepts",      "cstddef",   "cstdint",     "cstdio",
     "cstdlib",     "cstring",       "deque",         "exception", "functional",  "initializer_list",
     "iomanip",     "iostream",      "iterator",      "limits",    "list",        "map",
     "memory",      "numbers",       "numeric",       "optional",  "ostream",     "queue",
     "random",      "ranges",        "ratio",         "regex",     "set",         "span",
     "sstream",     "stack",         "stdexcept",     "string",    "string_view", "tuple",
     "type_traits", "unordered_map", "unordered_set", "utility",   "valarray",    "variant",
     "vector"});

/// Reads a source text after translation phase 2 ([lex.phases]): a backslash at the end of a line joins it with the
/// next, except within a raw string.
class Cursor {
 public:
  explicit Cursor(std::string_view text) : text_(text) {}

  bool done() const { return skip_splices(at_) >= text_.size(); }
  char peek(std::size_t ahead = 0) const {
    std::size_t i = skip_splices(at_);
    for (; ahead > 0 && i < text_.size(); --ahead) i = skip_splices(i + 1);
    return i < text_.size() ? text_[i] : '\0';
  }
  char take() {
    move_to(skip_splices(at_));
    return take_raw();
  }
  bool take_if(std::string_view word) {
    for (std::size_t i = 0; i < word.size(); ++i)
      if (peek(i) != word[i]) return false;
    for (std::size_t i = 0; i < word.size(); ++i) take();
    return true;
  }
  /// Moves after the next `end`, without joining lines; to the end of the text if there is none.
  void take_raw_until(std::string_view end) {
    const std::size_t found = text_.find(end, at_);
    move_to(found == std::string_view::npos ? text_.size() : found + end.size());
  }
  int line() const { return line_; }

 private:
  std::size_t skip_splices(std::size_t i) const {
    while (i < text_.size() && text_[i] == '\\') {
      // GCC allows spaces between the backslash and the end of the line.
      std::size_t end = i + 1;
      while (end < text_.size() && (text_[end] == ' ' || text_[end] == '\t' || text_[end] == '\r')) ++end;
      if (end >= text_.size() || text_[end] != '\n') break;
      i = end + 1;
    }
    return i;
  }
  void move_to(std::size_t i) {
    line_ += static_cast<int>(std::count(text_.begin() + at_, text_.begin() + i, '\n'));
    at_ = i;
  }
  char take_raw() {
    if (at_ >= text_.size()) return '\0';
    const char c = text_[at_];
    move_to(at_ + 1);
    return c;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1;
};

/// Characters of an identifier; GCC also allows $ and UTF-8 letters.
bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '$' || static_cast<unsigned char>(c) >= 0x80;
}
bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

/// Skips a comment that starts here; false if none does.
bool skip_comment(Cursor& cursor) {
  if (cursor.take_if("//")) {
    while (!cursor.done() && cursor.peek() != '\n') cursor.take();
    return true;
  }
  if (!cursor.take_if("/*")) return false;
  while (!cursor.done() && !cursor.take_if("*/")) cursor.take();
  return true;
}

void skip_blanks_and_comments(Cursor& cursor) {
  while (is_blank(cursor.peek()) || (cursor.peek() == '/' && skip_comment(cursor)))
    if (is_blank(cursor.peek())) cursor.take();
}

/// Skips the rest of a literal after its opening quote. As for the compiler, it ends at the end of the line at the
/// latest.
void skip_literal(Cursor& cursor, char quote) {
  while (!cursor.done() && cursor.peek() != '\n') {
    const char c = cursor.take();
    if (c == quote) return;
    if (c == '\\' && cursor.peek() != '\n') cursor.take();
  }
}

/// Skips the rest of a raw string after R": delimiter ( ... ) delimiter ".
void skip_raw_string(Cursor& cursor) {
  std::string end = ")";
  while (!cursor.done() && cursor.peek() != '(' && end.size() <= 16) end += cursor.take();
  cursor.take_raw_until(end + '"');
}

/// Whether `c` continues the number in `word` ([lex.ppnumber]): 1'000, 1.5, 1e+3.
bool extends_number(const std::string& word, char c, char next) {
  if (word.empty() || !std::isdigit(static_cast<unsigned char>(word.front()))) return false;
  const char last = static_cast<char>(std::tolower(static_cast<unsigned char>(word.back())));
  return c == '.' || (c == '\'' && is_word(next)) || ((c == '+' || c == '-') && (last == 'e' || last == 'p'));
}

/// Skips a name or number, and a raw string that it is the prefix of: u8R"(...)".
void skip_word(Cursor& cursor) {
  std::string word;
  while (is_word(cursor.peek()) || extends_number(word, cursor.peek(), cursor.peek(1))) word += cursor.take();
  const bool raw = word == "R" || word == "LR" || word == "uR" || word == "UR" || word == "u8R";
  if (raw && cursor.take_if("\"")) skip_raw_string(cursor);
}

/// Reads the header after an include directive: "<cmath>" with its delimiters, or a macro as written. Stops before the
/// rest of the line, where a comment may begin.
std::string take_header(Cursor& cursor) {
  skip_blanks_and_comments(cursor);
  std::string header;
  const char open = cursor.peek();
  if (open == '<' || open == '"') {
    const char close = open == '<' ? '>' : '"';
    header += cursor.take();
    while (!cursor.done() && cursor.peek() != '\n') {
      header += cursor.take();
      if (header.back() == close) break;
    }
  } else {
    while (!cursor.done() && cursor.peek() != '\n' && cursor.peek() != '/') header += cursor.take();
    while (!header.empty() && is_blank(header.back())) header.pop_back();
  }
  return header;
}

/// Why an include is refused, and what to do instead.
std::string why_refused(const std::string& target, const std::vector<std::string>& contract_headers) {
  const bool angled = target.size() > 2 && target.front() == '<' && target.back() == '>';
  const bool quoted = target.size() > 2 && target.front() == '"' && target.back() == '"';
  if (!angled && !quoted) return "write the header's name in <> or \"\"";

  const std::string name = target.substr(1, target.size() - 2);
  if (name.starts_with("glm/"))
    return "GLM's other headers contain what the steps teach (look_at, perspective, translate, rotate ...); "
           "<glm/glm.hpp> has the vectors and matrices that you need";
  for (const std::string& header : contract_headers)
    if (header == name || header.ends_with("/" + name)) return fmt::format("write #include \"{}\"", header);
  if (angled)
    return "only headers for computation, containers and printing are; a step needs no files, threads or libraries";
  // The contracts themselves; what they include may be included too, and would be a long list.
  std::set<std::string> contracts;
  for (const std::string& header : contract_headers)
    if (std::ranges::count(header, '/') < 2) contracts.insert(header);
  return contracts.empty()
             ? "a step is built only from its listed files"
             : fmt::format("a step is built only from its listed files and from \"{}\" and what they include",
                           fmt::join(contracts, "\", \""));
}

bool allowed(const std::string& target, const std::string& step, const std::vector<std::string>& contract_headers) {
  if (target == "<glm/glm.hpp>") return true;
  if (target.size() < 3) return false;
  const std::string name = target.substr(1, target.size() - 2);
  if (target.front() == '"')
    return std::any_of(contract_headers.begin(), contract_headers.end(),
                       [&](const std::string& header) { return header == name || header == step + "/" + name; });
  return target.front() == '<' && std::find(allowed_standard_headers.begin(), allowed_standard_headers.end(), name) !=
                                      allowed_standard_headers.end();
}

}  // namespace

std::vector<Include> find_includes(std::string_view source) {
  std::vector<Include> includes;
  if (source.starts_with("\xEF\xBB\xBF")) source.remove_prefix(3);  // a byte-order mark, which compilers ignore
  Cursor cursor(source);
  bool line_start = true;  // only blanks and comments so far, so a '#' begins a directive
  while (!cursor.done()) {
    const char c = cursor.peek();
    if (c == '/' && skip_comment(cursor)) continue;
    if (line_start && (c == '#' || (c == '%' && cursor.peek(1) == ':'))) {
      const int line = cursor.line();
      cursor.take_if("%:") || cursor.take_if("#");
      skip_blanks_and_comments(cursor);
      std::string directive;
      while (is_word(cursor.peek())) directive += cursor.take();
      if (directive.starts_with("include") || directive == "import" || directive == "embed")
        includes.push_back({line, take_header(cursor)});
    } else if (is_word(c)) {
      skip_word(cursor);
    } else {
      cursor.take();
      if (c == '"' || c == '\'') skip_literal(cursor, c);
    }
    line_start = c == '\n' || (line_start && is_blank(c));
  }
  return includes;
}

std::string text_with_all_headers(const std::vector<std::string>& contract_headers) {
  std::string text = "#include <glm/glm.hpp>\n";
  for (const std::string_view header : allowed_standard_headers)
    text += fmt::format("#if __has_include(<{0}>)\n#include <{0}>\n#endif\n", header);
  for (const std::string& header : contract_headers) text += fmt::format("#include \"{}\"\n", header);
  return text;
}

std::string refused_includes(std::string_view source, const std::string& file, const std::string& step,
                             const std::vector<std::string>& contract_headers) {
  std::string refused;
  for (const Include& include : find_includes(source))
    if (!allowed(include.target, step, contract_headers))
      refused += fmt::format("{}:{}: #include {} is not allowed in a step: {}\n", file, include.line,
                             shorten(printable(include.target), 200), why_refused(include.target, contract_headers));
  return refused;
}

}  // namespace atelier::judge
