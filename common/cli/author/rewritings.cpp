#include "cli/author/rewritings.hpp"

#include "cli/author/edit_finder.hpp"

namespace atelier {
namespace {

class RewritingFinder : EditFinder {
 public:
  RewritingFinder(std::string_view marked, bool glsl) : EditFinder(marked), glsl_(glsl) {}

  std::vector<Edit> find() {
    for (std::size_t i = 0; i < tokens().size(); ++i) {
      if (!is_students(i)) continue;
      turn_round(i);
      write_out(i);
    }
    return take_edits();
  }

 private:
  /// Whether the operand before `at` is all that stands on the left side of its sum or product.
  bool begins_expression(const TokenRange& left, bool product) const {
    if (left.begin == 0) return false;
    const Token& before = tokens()[left.begin - 1];
    if (before.kind != Token::Kind::symbol) return before.is("return");
    for (const char* word : {"(", ",", "=", "{", "+=", "-=", "?", ":", "<", ">", "<=", ">=", "&&", "||", "[", ";"})
      if (before.is(word)) return true;
    return product && (before.is("+") || before.is("-")) && !is_unary(tokens(), left.begin - 1);
  }

  void turn_round(std::size_t i) {
    const Token& token = tokens()[i];
    if (token.kind != Token::Kind::symbol || is_unary(tokens(), i) || is_template_bracket(tokens(), i)) return;
    const auto left = operand_before(tokens(), i), right = operand_behind(tokens(), i);
    if (!left || !right || at(left->begin, "-")) return;
    const std::string a = text(*left), b = text(*right);
    const TokenRange both{left->begin, right->end};
    const bool sum = token.is("+"), product = token.is("*");
    if (sum && begins_expression(*left, false) && !binds_tighter(right->end))
      replace(both, b + " + " + a, "sum turned");
    if (product && begins_expression(*left, true) && !is_matrix(a) && !is_matrix(b))
      replace(both, b + " * " + a, "product turned");
    if (token.is("-") && begins_expression(*left, false) && !binds_tighter(right->end))
      replace(both, a + " + (-(" + b + "))", "difference");
    if (const auto other = partner_of(turned_comparisons, token.text);
        other && begins_expression(*left, false) && ends_expression(right->end))
      replace(both, b + " " + std::string(*other) + " " + a, "comparison turned");
  }

  bool binds_tighter(std::size_t i) const { return at(i, "*") || at(i, "/") || at(i, "%"); }
  bool ends_expression(std::size_t i) const {
    return at(i, ")") || at(i, ";") || at(i, "&&") || at(i, "||") || at(i, "?") || at(i, ",");
  }

  void write_out(std::size_t i) {
    if (glsl_ && at(i, "/")) {
      const auto left = operand_before(tokens(), i), right = operand_behind(tokens(), i);
      if (left && right && begins_expression(*left, true))
        replace(TokenRange{left->begin, right->end}, text(*left) + " * (1.0 / (" + text(*right) + "))", "quotient");
    }
    if (glsl_ && at(i, "normalize") && at(i + 1, "(")) {
      const auto close = closing_of(tokens(), i + 1);
      const std::string v = close ? text({i + 2, *close}) : "";
      if (close) replace(TokenRange{i, *close + 1}, "((" + v + ") / length(" + v + "))", "normalize");
    }
    if ((at(i, "+=") || at(i, "*=")) && i > 0 && begins_statement(i - 1)) {
      if (const auto end = end_of_statement(tokens(), i - 1)) {
        const std::string name(tokens()[i - 1].text);
        replace(TokenRange{i - 1, *end},
                name + " = " + name + " " + std::string(1, tokens()[i].text[0]) + " (" + text({i + 1, *end}) + ")",
                "written out");
      }
    }
    if (at(i, "if") && at(i + 1, "(")) {
      const auto close = closing_of(tokens(), i + 1);
      if (close && at(*close + 1, "return"))
        replace(TokenRange{i + 2, *close}, "(" + text({i + 2, *close}) + ") == true", "guard");
    }
    if (!glsl_ && at(i, "return") && i > 0 && (at(i - 1, ";") || at(i - 1, "}")) && !at(i + 1, "{") && !at(i + 1, ";"))
      if (const auto end = end_of_statement(tokens(), i))
        replace(TokenRange{i, *end}, "auto the_result = " + text({i + 1, *end}) + "; return the_result", "temporary");
  }

  bool glsl_;
};

}  // namespace

std::vector<Edit> rewritings_of(std::string_view marked, bool glsl) {
  return RewritingFinder(marked, glsl).find();
}

}  // namespace atelier
