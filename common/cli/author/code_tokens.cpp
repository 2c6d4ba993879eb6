#include "cli/author/code_tokens.hpp"

#include <algorithm>
#include <array>

#include "cli/code_text.hpp"

namespace atelier {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

constexpr auto long_symbols =
    std::to_array<std::string_view>({"<<=", ">>=", "<=", ">=", "==", "!=", "&&", "||",
                                     "+=", "-=", "*=", "/=", "%=", "++", "--", "->", "::", "<<", ">>"});

/// The end of a comment, a string, a character or a preprocessor line that begins at `at`; `at` where none does.
std::size_t end_of_passed_over(std::string_view text, std::size_t at, bool first_of_line) {
  if (text.compare(at, 2, "//") == 0 || (first_of_line && text[at] == '#'))
    return std::min(text.find('\n', at), text.size());
  if (text.compare(at, 2, "/*") == 0) {
    const std::size_t close = text.find("*/", at + 2);
    return close == text.npos ? text.size() : close + 2;
  }
  if (text[at] == '"' || text[at] == '\'') {
    std::size_t end = at + 1;
    while (end < text.size() && text[end] != text[at] && text[end] != '\n') end += text[end] == '\\' ? 2 : 1;
    return std::min(end + 1, text.size());
  }
  return at;
}

/// A number with its exponent and its suffix.
std::size_t end_of_number(std::string_view text, std::size_t at) {
  std::size_t end = at;
  while (end < text.size() &&
         (in_identifier(text[end]) || text[end] == '.' ||
          ((text[end] == '+' || text[end] == '-') && (text[end - 1] == 'e' || text[end - 1] == 'E'))))
    ++end;
  return end;
}

bool opens(const Token& token) {
  return token.is("(") || token.is("[") || token.is("{");
}
bool closes(const Token& token) {
  return token.is(")") || token.is("]") || token.is("}");
}

bool joins_names(const Token& token) {
  return token.is(".") || token.is("::") || token.is("->");
}

}  // namespace

std::vector<Token> tokens_of(std::string_view text) {
  std::vector<Token> tokens;
  bool first_of_line = true;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (c == '\n') first_of_line = true;
    if (c == ' ' || c == '\t' || c == '\r' || c == '\n') {
      ++at;
      continue;
    }
    if (const std::size_t end = end_of_passed_over(text, at, first_of_line); end != at) {
      at = end;
      first_of_line = false;
      continue;
    }
    first_of_line = false;
    Token token{.begin = at};
    std::size_t end = at + 1;
    if (in_identifier(c) && !is_digit(c)) {
      token.kind = Token::Kind::identifier;
      while (end < text.size() && in_identifier(text[end])) ++end;
    } else if (is_digit(c) || (c == '.' && at + 1 < text.size() && is_digit(text[at + 1]))) {
      token.kind = Token::Kind::number;
      end = end_of_number(text, at);
    } else {
      for (const std::string_view symbol : long_symbols)
        if (text.compare(at, symbol.size(), symbol) == 0) {
          end = at + symbol.size();
          break;
        }
    }
    token.text = text.substr(at, end - at);
    tokens.push_back(token);
    at = end;
  }
  return tokens;
}

std::optional<std::size_t> closing_of(const std::vector<Token>& tokens, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < tokens.size(); ++i) {
    if (opens(tokens[i])) ++depth;
    if (closes(tokens[i]) && --depth == 0) return i;
  }
  return std::nullopt;
}

std::optional<std::size_t> opening_of(const std::vector<Token>& tokens, std::size_t close) {
  int depth = 0;
  for (std::size_t i = close + 1; i-- > 0;) {
    if (closes(tokens[i])) ++depth;
    if (opens(tokens[i]) && --depth == 0) return i;
  }
  return std::nullopt;
}

bool is_unary(const std::vector<Token>& tokens, std::size_t at) {
  if (at == 0) return true;
  const Token& before = tokens[at - 1];
  if (before.kind == Token::Kind::number || closes(before)) return false;
  return before.kind != Token::Kind::identifier || before.is("return") || before.is("else") || before.is("case");
}

std::optional<TokenRange> operand_before(const std::vector<Token>& tokens, std::size_t at) {
  std::size_t begin = at;
  while (begin > 0) {
    const Token& token = tokens[begin - 1];
    if (closes(token)) {
      const auto open = opening_of(tokens, begin - 1);
      if (!open) return std::nullopt;
      begin = *open;
      // What stands before the bracket belongs to it where it is called or indexed.
      if (begin == 0 || (tokens[begin - 1].kind != Token::Kind::identifier && !closes(tokens[begin - 1]))) break;
      if (tokens[begin - 1].is("return")) break;
      continue;
    }
    if (token.kind == Token::Kind::symbol || token.is("return")) break;
    --begin;
    if (begin == 0 || !joins_names(tokens[begin - 1])) break;
    --begin;
  }
  if (begin == at) return std::nullopt;
  if (begin > 0 && tokens[begin - 1].is("-") && is_unary(tokens, begin - 1)) --begin;
  return TokenRange{begin, at};
}

std::optional<TokenRange> operand_behind(const std::vector<Token>& tokens, std::size_t at) {
  std::size_t end = at + 1;
  while (end < tokens.size() && (tokens[end].is("-") || tokens[end].is("!"))) ++end;
  if (end >= tokens.size()) return std::nullopt;
  if (opens(tokens[end])) {
    const auto close = closing_of(tokens, end);
    if (!close) return std::nullopt;
    end = *close + 1;
  } else if (tokens[end].kind == Token::Kind::symbol) {
    return std::nullopt;
  } else {
    ++end;
  }
  while (end < tokens.size()) {
    if (joins_names(tokens[end]) && end + 1 < tokens.size()) {
      end += 2;
    } else if (tokens[end].is("(") || tokens[end].is("[")) {
      const auto close = closing_of(tokens, end);
      if (!close) return std::nullopt;
      end = *close + 1;
    } else {
      break;
    }
  }
  return TokenRange{at + 1, end};
}

bool is_template_bracket(const std::vector<Token>& tokens, std::size_t at) {
  const auto may_be_inside = [&](const Token& token) {
    return token.kind != Token::Kind::symbol || token.is("::") || token.is(",") || token.is("&") || token.is("*");
  };
  const auto follows_a_name = [&](std::size_t open) {
    return open > 0 && tokens[open - 1].kind == Token::Kind::identifier && tokens[open - 1].end() == tokens[open].begin;
  };
  if (tokens[at].is("<")) {
    std::size_t i = at + 1;
    while (i < tokens.size() && may_be_inside(tokens[i])) ++i;
    return i < tokens.size() && tokens[i].is(">") && follows_a_name(at);
  }
  if (!tokens[at].is(">")) return false;
  std::size_t i = at;
  while (i > 0 && may_be_inside(tokens[i - 1])) --i;
  return i > 0 && tokens[i - 1].is("<") && follows_a_name(i - 1);
}

std::vector<TokenRange> arguments_of(const std::vector<Token>& tokens, std::size_t open) {
  std::vector<TokenRange> arguments;
  const auto close = closing_of(tokens, open);
  if (!close || *close == open + 1) return arguments;
  std::size_t begin = open + 1;
  int depth = 0;
  for (std::size_t i = open + 1; i < *close; ++i) {
    if (opens(tokens[i])) ++depth;
    if (closes(tokens[i])) --depth;
    if (depth == 0 && tokens[i].is(",")) {
      arguments.push_back({begin, i});
      begin = i + 1;
    }
  }
  arguments.push_back({begin, *close});
  return arguments;
}

std::optional<std::size_t> end_of_statement(const std::vector<Token>& tokens, std::size_t begin) {
  for (std::size_t end = begin; end < tokens.size(); ++end) {
    if (opens(tokens[end])) {
      const auto close = closing_of(tokens, end);
      if (!close) return std::nullopt;
      end = *close;
    }
    if (tokens[end].is(";")) return end;
    if (tokens[end].is("}")) return std::nullopt;
  }
  return std::nullopt;
}

std::string_view text_of(std::string_view text, const std::vector<Token>& tokens, const TokenRange& range) {
  const std::size_t begin = tokens[range.begin].begin;
  return text.substr(begin, tokens[range.end - 1].end() - begin);
}

}  // namespace atelier
