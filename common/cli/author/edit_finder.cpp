#include "cli/author/edit_finder.hpp"

#include <algorithm>

#include "cli/author/marked_text.hpp"

namespace atelier {
bool is_matrix(std::string_view name) {
  for (const char* part : {"matri", "mat3", "projection", "view", "model", "rotation", "scaling", "translation",
                           "frame", "passage", "world_to", "_to_"})
    if (name.find(part) != name.npos) return true;
  return false;
}

EditFinder::EditFinder(std::string_view marked)
    : text_(marked), tokens_(tokens_of(marked)), parts_(student_parts(marked)) {}

bool EditFinder::is_students(std::size_t token) const {
  const std::size_t place = tokens_[token].begin;
  return std::any_of(parts_.begin(), parts_.end(),
                     [&](const auto& part) { return place >= part.first && place < part.second; });
}

void EditFinder::replace(std::size_t token, std::string_view by, const char* kind) {
  edits_.push_back({tokens_[token].begin, tokens_[token].end(), std::string(by), kind});
}

void EditFinder::replace(const TokenRange& range, std::string by, const char* kind) {
  edits_.push_back({tokens_[range.begin].begin, tokens_[range.end - 1].end(), std::move(by), kind});
}

bool EditFinder::begins_statement(std::size_t i) const {
  if (tokens_[i].kind != Token::Kind::identifier || i == 0) return false;
  for (const char* word : {"return", "if", "for", "while", "else", "const", "auto", "case", "break", "continue"})
    if (tokens_[i].is(word)) return false;
  const Token& before = tokens_[i - 1];
  if (before.is(")")) {
    const auto open = opening_of(tokens_, i - 1);
    return open && *open > 0 && (tokens_[*open - 1].is("if") || tokens_[*open - 1].is("for"));
  }
  if (before.is(";")) return !in_round_brackets(i);
  return before.is("{") || before.is("}") || before.is("else");
}

bool EditFinder::in_round_brackets(std::size_t i) const {
  for (std::size_t k = i; k-- > 0;) {
    if (tokens_[k].is("(")) return true;
    if (tokens_[k].is(")") || tokens_[k].is("{") || tokens_[k].is("}")) return false;
  }
  return false;
}

}  // namespace atelier
