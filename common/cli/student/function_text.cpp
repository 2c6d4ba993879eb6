#include "cli/student/function_text.hpp"

#include <algorithm>

namespace atelier {
namespace {

constexpr std::size_t nowhere = std::string_view::npos;

/// The text with everything blank that is no code: comments, strings, characters. Lines and places stay.
std::string code_only(std::string_view text) {
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
      blank(i, ++end);
    }
    i = end;
  }
  return code;
}

bool in_identifier(char c) {
  return c == '_' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// The place behind the bracket that closes the one at `open`.
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

/// The place behind the body of a definition whose name stands at `at`; nowhere where it is none (a call, say).
std::size_t end_of_definition(std::string_view code, std::size_t at, std::size_t name_length) {
  const std::size_t parameters = skip_space(code, at + name_length);
  if (parameters >= code.size() || code[parameters] != '(') return nowhere;
  const std::size_t behind = behind_bracket(code, parameters, '(', ')');
  if (behind == nowhere) return nowhere;
  const std::size_t body = skip_space(code, behind);
  return body < code.size() && code[body] == '{' ? behind_bracket(code, body, '{', '}') : nowhere;
}

}  // namespace

std::optional<FunctionText> find_function(std::string_view text, std::string_view name) {
  const std::string code = code_only(text);
  for (std::size_t at = code.find(name); at != nowhere; at = code.find(name, at + 1)) {
    if (at > 0 && in_identifier(code[at - 1])) continue;
    const std::size_t end = end_of_definition(code, at, name.size());
    if (end == nowhere) continue;
    const std::size_t line_end = std::min(text.find('\n', end), text.size());
    const std::size_t before = text.rfind('\n', at);
    const std::size_t begin = before == nowhere ? 0 : before + 1;
    return FunctionText{.line = int(std::count(text.begin(), text.begin() + std::ptrdiff_t(begin), '\n')) + 1,
                        .text = std::string(text.substr(begin, line_end - begin)) + "\n"};
  }
  return std::nullopt;
}

}  // namespace atelier
