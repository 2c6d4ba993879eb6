#include "cli/student/function_text.hpp"

#include <algorithm>
#include <iterator>
#include <sstream>
#include <vector>

#include "cli/code_text.hpp"

namespace atelier {
namespace {

constexpr std::size_t nowhere = std::string_view::npos;

/// The text with its comments and, if `strings`, its string and character literals replaced by spaces. Positions do not
/// change.
std::string blanked(std::string_view text, bool strings) {
  std::string code(text);
  const auto blank = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < std::min(end, code.size()); ++i)
      if (code[i] != '\n') code[i] = ' ';
  };
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i + 1;
    if (text.compare(i, 2, "//") == 0) {
      end = std::min(text.find('\n', i), text.size());
      blank(i, end);
    } else if (text.compare(i, 2, "/*") == 0) {
      const std::size_t close = text.find("*/", i + 2);
      end = close == nowhere ? text.size() : close + 2;
      blank(i, end);
    } else if (text[i] == '"' || text[i] == '\'') {
      while (end < text.size() && text[end] != text[i] && text[end] != '\n') end += text[end] == '\\' ? 2 : 1;
      ++end;
      if (strings) blank(i, end);
    }
    i = end;
  }
  return code;
}

std::string code_only(std::string_view text) {
  return blanked(text, true);
}

/// The position after the bracket that closes the one at `open`.
std::size_t behind_bracket(std::string_view code, std::size_t open, char opens, char closes) {
  int depth = 0;
  for (std::size_t i = open; i < code.size(); ++i) {
    if (code[i] == opens) ++depth;
    if (code[i] == closes && --depth == 0) return i + 1;
  }
  return nowhere;
}

std::size_t skip_space(std::string_view code, std::size_t at) {
  return std::min(code.find_first_not_of(" \t\r\n", at), code.size());
}

/// The position after the parameters of a function whose name is at `at`; npos if none follow.
std::size_t end_of_head(std::string_view code, std::size_t at, std::size_t name_length) {
  const std::size_t parameters = skip_space(code, at + name_length);
  if (parameters >= code.size() || code[parameters] != '(') return nowhere;
  return behind_bracket(code, parameters, '(', ')');
}

/// The position after the body of a definition whose name is at `at`; npos if it is not a definition (a call, for
/// example).
std::size_t end_of_definition(std::string_view code, std::size_t at, std::size_t name_length) {
  const std::size_t behind = end_of_head(code, at, name_length);
  if (behind == nowhere) return nowhere;
  const std::size_t body = skip_space(code, behind);
  return body < code.size() && code[body] == '{' ? behind_bracket(code, body, '{', '}') : nowhere;
}

/// The beginning of the comment lines directly above the line that begins at `line`; `line` itself if there are none.
std::size_t begin_of_comment(std::string_view text, std::size_t line) {
  while (line > 0) {
    const std::size_t above = begin_of_line(text, line - 1);
    const std::size_t first = text.find_first_not_of(" \t", above);
    if (text.compare(first, 2, "//") != 0) break;
    line = above;
  }
  return line;
}

/// The positions at which `name` is a whole word of the code.
std::vector<std::size_t> places_of(std::string_view code, std::string_view name) {
  std::vector<std::size_t> places;
  for (std::size_t at = code.find(name); at != nowhere; at = code.find(name, at + 1))
    if (at == 0 || !in_identifier(code[at - 1])) places.push_back(at);
  return places;
}

}  // namespace

std::optional<FunctionText> find_function(std::string_view text, std::string_view name) {
  const std::string code = code_only(text);
  for (const std::size_t at : places_of(code, name)) {
    const std::size_t end = end_of_definition(code, at, name.size());
    if (end == nowhere) continue;
    const std::size_t line_end = std::min(text.find('\n', end), text.size()), begin = begin_of_line(text, at);
    return FunctionText{.line = line_number(text, begin),
                        .text = std::string(text.substr(begin, line_end - begin)) + "\n"};
  }
  return std::nullopt;
}

bool same_code(std::string_view a, std::string_view b) {
  const auto words = [](std::string_view text) {
    std::istringstream stream(blanked(text, false));
    return std::vector<std::string>(std::istream_iterator<std::string>(stream), {});
  };
  return words(a) == words(b);
}

std::optional<FunctionText> find_contract(std::string_view text, std::string_view name) {
  const std::string code = code_only(text);
  for (const std::size_t at : places_of(code, name)) {
    const std::size_t end = end_of_head(code, at, name.size());
    if (end == nowhere) continue;
    const std::size_t next = skip_space(code, end);
    const bool declares = next < code.size() && (code[next] == ';' || code[next] == '{');
    const std::size_t line = begin_of_line(text, at), begin = begin_of_comment(text, line);
    if (!declares || begin == line) continue;
    return FunctionText{.line = line_number(text, line), .text = std::string(text.substr(begin, end - begin)) + "\n"};
  }
  return std::nullopt;
}

}  // namespace atelier
