#include "cli/author/mutations.hpp"

#include <algorithm>
#include <array>

#include "cli/author/edit_finder.hpp"

namespace atelier {
namespace {

using Kind = Token::Kind;

constexpr auto exchanged_operators = std::to_array<std::pair<std::string_view, std::string_view>>({{"+", "-"},
                                                                                                   {"-", "+"},
                                                                                                   {"*", "/"},
                                                                                                   {"/", "*"},
                                                                                                   {"<", "<="},
                                                                                                   {"<=", "<"},
                                                                                                   {">", ">="},
                                                                                                   {">=", ">"},
                                                                                                   {"==", "!="},
                                                                                                   {"!=", "=="},
                                                                                                   {"&&", "||"},
                                                                                                   {"||", "&&"},
                                                                                                   {"+=", "-="},
                                                                                                   {"-=", "+="},
                                                                                                   {"*=", "/="}});

constexpr auto exchanged_names = std::to_array<std::pair<std::string_view, std::string_view>>({{"min", "max"},
                                                                                               {"max", "min"},
                                                                                               {"sin", "cos"},
                                                                                               {"cos", "sin"},
                                                                                               {"asin", "acos"},
                                                                                               {"acos", "asin"},
                                                                                               {"floor", "ceil"},
                                                                                               {"true", "false"},
                                                                                               {"false", "true"},
                                                                                               {"dFdx", "dFdy"},
                                                                                               {"dFdy", "dFdx"}});

/// Calls that a student may forget: what is left is the first argument.
constexpr auto forgotten_calls =
    std::to_array<std::string_view>({"normalize", "abs", "sqrt", "radians", "clamp", "max", "min", "transpose",
                                     "inverse", "floor", "inversesqrt", "fract"});

/// Exchanging the first two arguments of these changes nothing.
constexpr auto symmetric_calls = std::to_array<std::string_view>({"max", "min", "dot", "distance", "equal"});

constexpr auto sibling_enums = std::to_array<std::pair<std::string_view, std::string_view>>(
    {{"GL_NEAREST", "GL_LINEAR"},
     {"GL_LINEAR", "GL_NEAREST"},
     {"GL_LESS", "GL_GREATER"},
     {"GL_LEQUAL", "GL_GEQUAL"},
     {"GL_FRONT", "GL_BACK"},
     {"GL_BACK", "GL_FRONT"},
     {"GL_CLAMP_TO_BORDER", "GL_CLAMP_TO_EDGE"},
     {"GL_CLAMP_TO_EDGE", "GL_REPEAT"},
     {"GL_REPEAT", "GL_MIRRORED_REPEAT"},
     {"GL_MIRRORED_REPEAT", "GL_REPEAT"},
     {"GL_LINEAR_MIPMAP_LINEAR", "GL_LINEAR_MIPMAP_NEAREST"},
     {"GL_TEXTURE_MIN_FILTER", "GL_TEXTURE_MAG_FILTER"},
     {"GL_TEXTURE_MAG_FILTER", "GL_TEXTURE_MIN_FILTER"},
     {"GL_TEXTURE_WRAP_S", "GL_TEXTURE_WRAP_T"},
     {"GL_TEXTURE_WRAP_T", "GL_TEXTURE_WRAP_S"},
     {"GL_TEXTURE_WRAP_R", "GL_TEXTURE_WRAP_S"},
     {"GL_ARRAY_BUFFER", "GL_ELEMENT_ARRAY_BUFFER"},
     {"GL_ELEMENT_ARRAY_BUFFER", "GL_ARRAY_BUFFER"},
     {"GL_LINE", "GL_FILL"},
     {"GL_FILL", "GL_LINE"},
     {"GL_DEPTH_TEST", "GL_CULL_FACE"},
     {"GL_CULL_FACE", "GL_DEPTH_TEST"},
     {"GL_TRUE", "GL_FALSE"},
     {"GL_FALSE", "GL_TRUE"},
     {"GL_FLOAT", "GL_HALF_FLOAT"},
     {"GL_RGBA32F", "GL_RGBA8"},
     {"GL_SRGB8_ALPHA8", "GL_RGBA8"},
     {"GL_NONE", "GL_COLOR_ATTACHMENT0"},
     {"Enable", "Disable"},
     {"Disable", "Enable"}});

template <class Words>
bool contains(const Words& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

class MutationFinder : EditFinder {
 public:
  explicit MutationFinder(std::string_view marked) : EditFinder(marked) {}

  std::vector<Edit> find() {
    for (std::size_t i = 0; i < tokens().size(); ++i) {
      if (!is_students(i)) continue;
      exchange(i);
      change_number(i);
      change_call(i);
      change_swizzle(i);
      change_product(i);
      leave_out(i);
      exchange_arms(i);
    }
    return take_edits();
  }

 private:
  void exchange(std::size_t i) {
    const Token& token = tokens()[i];
    if (token.kind == Kind::symbol) {
      if ((token.is("-") || token.is("*") || token.is("&")) && is_unary(tokens(), i)) {
        if (token.is("-")) replace(i, "", "sign");
        return;
      }
      if (is_template_bracket(tokens(), i)) return;
      if (token.is("!")) replace(i, "", "negation");
      if (const auto other = partner_of(exchanged_operators, token.text)) replace(i, *other, "operator");
      if (const auto other = partner_of(turned_comparisons, token.text)) replace(i, *other, "comparison");
      return;
    }
    if (const auto other = partner_of(sibling_enums, token.text)) replace(i, *other, "enum");
    if (const auto other = partner_of(exchanged_names, token.text)) replace(i, *other, "name");
  }

  void change_number(std::size_t i) {
    if (tokens()[i].kind != Kind::number) return;
    const std::string number(tokens()[i].text);
    const bool whole = number.find_first_not_of("0123456789") == number.npos;
    const bool zero = number.find_first_not_of("0.fF") == number.npos;
    if (zero)
      replace(i, whole ? "1" : number.back() == 'f' ? "1.0f" : "1.0", "constant");
    else if (whole)
      replace(i, std::to_string(std::stoll(number) + 1), "constant");
    else
      replace(i, (number.back() == 'f' ? "(2.0f * " : "(2.0 * ") + number + ")", "constant");
  }

  void change_call(std::size_t i) {
    if (tokens()[i].kind != Kind::identifier || !at(i + 1, "(")) return;
    const auto arguments = arguments_of(tokens(), i + 1);
    const auto close = closing_of(tokens(), i + 1);
    if (arguments.empty() || !close) return;
    if (contains(forgotten_calls, tokens()[i].text)) {
      std::size_t begin = i;
      while (begin >= 2 && tokens()[begin - 1].is("::")) begin -= 2;
      replace(TokenRange{begin, *close + 1}, "(" + text(arguments[0]) + ")", "call");
    }
    if (contains(symmetric_calls, tokens()[i].text) || tokens()[i].is("if") || tokens()[i].is("for")) return;
    for (std::size_t k = 0; k + 1 < arguments.size(); ++k)
      if (const std::string a = text(arguments[k]), b = text(arguments[k + 1]); a != b)
        replace(TokenRange{arguments[k].begin, arguments[k + 1].end}, b + ", " + a, "arguments");
  }

  void change_swizzle(std::size_t i) {
    if (!at(i, ".") || i + 1 >= tokens().size() || at(i + 2, "(")) return;
    const std::string_view name = tokens()[i + 1].text;
    constexpr std::string_view letters = "xyzw";
    if (name.size() > 4 || name.find_first_not_of(letters) != name.npos) return;
    std::string other(name);
    if (name.size() == 1)
      other = name == "x" ? "y" : name == "w" ? "z" : "x";
    else
      std::swap(other[0], other[1]);
    replace(i + 1, other, "swizzle");
  }

  void change_product(std::size_t i) {
    if (!at(i, "*") || is_unary(tokens(), i)) return;
    const auto left = operand_before(tokens(), i), right = operand_behind(tokens(), i);
    if (!left || !right) return;
    const std::string a = text(*left), b = text(*right);
    if (is_matrix(a) && is_matrix(b)) replace(TokenRange{left->begin, right->end}, b + " * " + a, "matrix order");
  }

  /// The end of what an operator at `i` of this binding takes in on its right side.
  std::size_t end_of_term(std::size_t i, bool factor) const {
    std::size_t end = i + 1;
    for (int depth = 0; end < tokens().size(); ++end) {
      const Token& token = tokens()[end];
      if (token.is("(") || token.is("[") || token.is("{")) ++depth;
      if (token.is(")") || token.is("]") || token.is("}"))
        if (--depth < 0) break;
      if (depth > 0 || token.kind != Kind::symbol || end == i + 1) continue;
      if (token.is(".") || token.is("::") || token.is("->") || token.is("(") || token.is("[") || token.is(")") ||
          token.is("]"))
        continue;
      if (factor || !(token.is("*") || token.is("/"))) break;
    }
    return end;
  }

  void leave_out(std::size_t i) {
    const Token& token = tokens()[i];
    const bool sum = token.is("+") || token.is("-"), product = token.is("*") || token.is("/");
    if ((sum || product) && !is_unary(tokens(), i))
      replace(TokenRange{i, end_of_term(i, product)}, "", sum ? "term" : "factor");
    if (token.is("if") && at(i + 1, "(")) {
      const auto close = closing_of(tokens(), i + 1);
      if (close) replace(TokenRange{i + 2, *close}, "false", "guard");
    }
    if (begins_statement(i))
      if (const auto end = end_of_statement(tokens(), i); end && !declares(i))
        replace(TokenRange{i, *end}, "", "statement");
  }

  bool declares(std::size_t i) const {
    return i + 1 < tokens().size() &&
           (tokens()[i + 1].kind == Kind::identifier || at(i + 1, "::") || at(i + 1, "&") || at(i + 1, "<"));
  }

  void exchange_arms(std::size_t i) {
    if (!at(i, "?")) return;
    std::size_t colon = i + 1;
    for (int depth = 0; colon < tokens().size(); ++colon) {
      if (at(colon, "(") || at(colon, "[") || at(colon, "{")) ++depth;
      if (at(colon, ")") || at(colon, "]") || at(colon, "}")) --depth;
      if (depth == 0 && at(colon, "?")) return;  // a chain of them
      if (depth == 0 && at(colon, ":")) break;
    }
    std::size_t end = colon + 1;
    for (int depth = 0; end < tokens().size(); ++end) {
      if (at(end, "(") || at(end, "[") || at(end, "{")) ++depth;
      if (at(end, ")") || at(end, "]") || at(end, "}"))
        if (--depth < 0) break;
      if (depth == 0 && (at(end, ";") || at(end, ","))) break;
      if (depth == 0 && at(end, "?")) return;
    }
    if (end >= tokens().size() || end == colon + 1) return;
    replace(TokenRange{i + 1, end}, text({colon + 1, end}) + " : " + text({i + 1, colon}), "arms");
  }
};

}  // namespace

std::vector<Edit> mutations_of(std::string_view marked) {
  return MutationFinder(marked).find();
}

}  // namespace atelier
