// The tokens of a text in C++ or GLSL, and what belongs together among them: enough to change one thing at a time.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace atelier {

struct Token {
  enum class Kind { identifier, number, symbol } kind = Kind::symbol;
  std::string_view text;  ///< of the text that was given, which must outlive it
  std::size_t begin = 0;  ///< its place in that text
  std::size_t end() const { return begin + text.size(); }
  bool is(std::string_view word) const { return text == word; }
};

/// All tokens; comments, strings, characters and preprocessor lines are passed over. Symbols of several characters
/// (`<=`, `+=`, `&&`, `->`, `::`) are one token.
std::vector<Token> tokens_of(std::string_view text);

/// Places in a list of tokens, [begin, end).
struct TokenRange {
  std::size_t begin = 0, end = 0;
};

/// The bracket that closes the one at `open`, or opens the one at `close`; nothing where there is none.
std::optional<std::size_t> closing_of(const std::vector<Token>& tokens, std::size_t open);
std::optional<std::size_t> opening_of(const std::vector<Token>& tokens, std::size_t close);

/// The operand before, or behind, a binary operator at `at`: a name with its qualifiers, members, indices and
/// arguments, a number, or an expression in brackets; a sign before it belongs to it.
std::optional<TokenRange> operand_before(const std::vector<Token>& tokens, std::size_t at);
std::optional<TokenRange> operand_behind(const std::vector<Token>& tokens, std::size_t at);

/// Whether the symbol at `at` (+ - * &) stands before its only operand.
bool is_unary(const std::vector<Token>& tokens, std::size_t at);

/// Whether the '<' or '>' at `at` encloses arguments of a template, as in std::vector<float>: what is between the two
/// are names, commas, '::', '&', '*' and numbers, and no space stands before the '<'.
bool is_template_bracket(const std::vector<Token>& tokens, std::size_t at);

/// The arguments of the call whose opening bracket is at `open`.
std::vector<TokenRange> arguments_of(const std::vector<Token>& tokens, std::size_t open);

/// The ';' of the statement that begins at `begin`; nothing where a '}' comes first.
std::optional<std::size_t> end_of_statement(const std::vector<Token>& tokens, std::size_t begin);

/// The text from the first to the last token of a range, which is not empty.
std::string_view text_of(std::string_view text, const std::vector<Token>& tokens, const TokenRange& range);

}  // namespace atelier
