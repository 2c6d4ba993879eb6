// Base of the classes that look for edits in what a student writes of a marked solution.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/author/code_tokens.hpp"
#include "cli/author/edits.hpp"

namespace atelier {

/// Comparisons with their operands exchanged.
inline constexpr std::pair<std::string_view, std::string_view> turned_comparisons[] = {
    {"<", ">"}, {">", "<"}, {"<=", ">="}, {">=", "<="}};

/// The second word of the pair that begins with `word`.
template <class Pairs>
std::optional<std::string_view> partner_of(const Pairs& pairs, std::string_view word) {
  for (const auto& [from, to] : pairs)
    if (from == word) return to;
  return std::nullopt;
}

/// Names that suggest a matrix, whose product depends on the order.
bool is_matrix(std::string_view name);

class EditFinder {
 protected:
  explicit EditFinder(std::string_view marked);

  const std::vector<Token>& tokens() const { return tokens_; }
  /// Whether a token is between a student's marks, and not in the skeleton's lines.
  bool is_students(std::size_t token) const;
  bool at(std::size_t token, std::string_view word) const { return token < tokens_.size() && tokens_[token].is(word); }
  std::string text(const TokenRange& range) const { return std::string(text_of(text_, tokens_, range)); }

  /// A statement that is a call or an assignment, or a declaration.
  bool begins_statement(std::size_t token) const;

  void replace(std::size_t token, std::string_view by, const char* kind);
  void replace(const TokenRange& range, std::string by, const char* kind);
  std::vector<Edit> take_edits() { return std::move(edits_); }

 private:
  /// Whether a token is in the head of a loop.
  bool in_round_brackets(std::size_t token) const;

  std::string_view text_;
  std::vector<Token> tokens_;
  std::vector<std::pair<std::size_t, std::size_t>> parts_;  ///< of the text: what a student writes
  std::vector<Edit> edits_;
};

}  // namespace atelier
