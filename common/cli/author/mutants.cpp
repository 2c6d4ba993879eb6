#include "cli/author/mutants.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

#include "cli/author/code_tokens.hpp"

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

constexpr auto turned_comparisons =
    std::to_array<std::pair<std::string_view, std::string_view>>({{"<", ">"}, {">", "<"}, {"<=", ">="}, {">=", "<="}});

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

template <class Pairs>
std::optional<std::string_view> partner(const Pairs& pairs, std::string_view word) {
  for (const auto& [from, to] : pairs)
    if (from == word) return to;
  return std::nullopt;
}

template <class Words>
bool contains(const Words& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// Where a student writes: between the marks, without the skeleton's lines.
std::vector<std::pair<std::size_t, std::size_t>> student_parts(std::string_view marked) {
  std::vector<std::pair<std::size_t, std::size_t>> parts;
  for (std::size_t at = marked.find("// >>> student"); at != marked.npos; at = marked.find("// >>> student", at)) {
    const std::size_t begin = marked.find('\n', at), skeleton = marked.find("// --- skeleton", begin),
                      close = marked.find("// <<< student", begin);
    parts.emplace_back(begin, std::min(skeleton, close));
    at = close;
  }
  return parts;
}

/// Looks for changes in the tokens of a text, and keeps those within the student's parts.
class Finder {
 public:
  explicit Finder(std::string_view text) : text_(text), tokens_(tokens_of(text)), parts_(student_parts(text)) {}

  std::vector<Edit> mutations() {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (!is_students(tokens_[i].begin)) continue;
      exchange(i);
      change_number(i);
      change_call(i);
      change_swizzle(i);
      change_product(i);
      leave_out(i);
      exchange_arms(i);
    }
    return std::move(edits_);
  }

  std::vector<Edit> rewritings(bool glsl) {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (!is_students(tokens_[i].begin)) continue;
      turn_round(i);
      write_out(i, glsl);
    }
    return std::move(edits_);
  }

 private:
  bool is_students(std::size_t at) const {
    return std::any_of(parts_.begin(), parts_.end(),
                       [&](const auto& part) { return at >= part.first && at < part.second; });
  }
  bool at(std::size_t i, std::string_view word) const { return i < tokens_.size() && tokens_[i].is(word); }
  std::string text(const TokenRange& range) const { return std::string(text_of(text_, tokens_, range)); }

  void add(std::size_t begin, std::size_t end, std::string by, const char* kind) {
    edits_.push_back({begin, end, std::move(by), kind});
  }
  void replace(std::size_t token, std::string_view by, const char* kind) {
    add(tokens_[token].begin, tokens_[token].end(), std::string(by), kind);
  }
  void replace(const TokenRange& range, std::string by, const char* kind) {
    add(tokens_[range.begin].begin, tokens_[range.end - 1].end(), std::move(by), kind);
  }

  // ---- Mutations

  void exchange(std::size_t i) {
    const Token& token = tokens_[i];
    if (token.kind == Kind::symbol) {
      if ((token.is("-") || token.is("*") || token.is("&")) && is_unary(tokens_, i)) {
        if (token.is("-")) replace(i, "", "sign");
        return;
      }
      if (token.is("!")) replace(i, "", "negation");
      if (const auto other = partner(exchanged_operators, token.text)) replace(i, *other, "operator");
      if (const auto other = partner(turned_comparisons, token.text)) replace(i, *other, "comparison");
      return;
    }
    if (const auto other = partner(sibling_enums, token.text)) replace(i, *other, "enum");
    if (const auto other = partner(exchanged_names, token.text)) replace(i, *other, "name");
  }

  void change_number(std::size_t i) {
    if (tokens_[i].kind != Kind::number) return;
    const std::string number(tokens_[i].text);
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
    if (tokens_[i].kind != Kind::identifier || !at(i + 1, "(")) return;
    const auto arguments = arguments_of(tokens_, i + 1);
    const auto close = closing_of(tokens_, i + 1);
    if (arguments.empty() || !close) return;
    if (contains(forgotten_calls, tokens_[i].text)) {
      std::size_t begin = i;
      while (begin >= 2 && tokens_[begin - 1].is("::")) begin -= 2;
      replace(TokenRange{begin, *close + 1}, "(" + text(arguments[0]) + ")", "call");
    }
    if (contains(symmetric_calls, tokens_[i].text) || tokens_[i].is("if") || tokens_[i].is("for")) return;
    for (std::size_t k = 0; k + 1 < arguments.size(); ++k)
      if (const std::string a = text(arguments[k]), b = text(arguments[k + 1]); a != b)
        replace(TokenRange{arguments[k].begin, arguments[k + 1].end}, b + ", " + a, "arguments");
  }

  void change_swizzle(std::size_t i) {
    if (!at(i, ".") || i + 1 >= tokens_.size() || at(i + 2, "(")) return;
    const std::string_view name = tokens_[i + 1].text;
    constexpr std::string_view letters = "xyzw";
    if (name.size() > 4 || name.find_first_not_of(letters) != name.npos) return;
    std::string other(name);
    if (name.size() == 1)
      other = name == "x" ? "y" : name == "w" ? "z" : "x";
    else
      std::swap(other[0], other[1]);
    replace(i + 1, other, "swizzle");
  }

  /// Names of matrices, whose product depends on the order.
  static bool is_matrix(std::string_view name) {
    for (const char* part :
         {"matri", "projection", "view", "model", "rotation", "scaling", "translation", "world_to", "_to_"})
      if (name.find(part) != name.npos) return true;
    return false;
  }

  void change_product(std::size_t i) {
    if (!at(i, "*") || is_unary(tokens_, i)) return;
    const auto left = operand_before(tokens_, i), right = operand_behind(tokens_, i);
    if (!left || !right) return;
    const std::string a = text(*left), b = text(*right);
    if (is_matrix(a) && is_matrix(b)) replace(TokenRange{left->begin, right->end}, b + " * " + a, "matrix order");
  }

  /// The end of what an operator at `i` of this binding takes in on its right side.
  std::size_t end_of_term(std::size_t i, bool factor) const {
    std::size_t end = i + 1;
    for (int depth = 0; end < tokens_.size(); ++end) {
      const Token& token = tokens_[end];
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
    const Token& token = tokens_[i];
    const bool sum = token.is("+") || token.is("-"), product = token.is("*") || token.is("/");
    if ((sum || product) && !is_unary(tokens_, i))
      replace(TokenRange{i, end_of_term(i, product)}, "", sum ? "term" : "factor");
    if (token.is("if") && at(i + 1, "(")) {
      const auto close = closing_of(tokens_, i + 1);
      if (close) replace(TokenRange{i + 2, *close}, "false", "guard");
    }
    if (begins_statement(i))
      if (const auto end = end_of_statement(i); end && !declares(i)) replace(TokenRange{i, *end}, "", "statement");
  }

  bool begins_statement(std::size_t i) const {
    if (tokens_[i].kind != Kind::identifier || i == 0) return false;
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

  /// Within the head of a loop.
  bool in_round_brackets(std::size_t i) const {
    for (std::size_t k = i; k-- > 0;) {
      if (tokens_[k].is("(")) return true;
      if (tokens_[k].is(")") || tokens_[k].is("{") || tokens_[k].is("}")) return false;
    }
    return false;
  }

  bool declares(std::size_t i) const {
    return i + 1 < tokens_.size() &&
           (tokens_[i + 1].kind == Kind::identifier || at(i + 1, "::") || at(i + 1, "&") || at(i + 1, "<"));
  }

  std::optional<std::size_t> end_of_statement(std::size_t i) const {
    for (std::size_t end = i; end < tokens_.size(); ++end) {
      if (tokens_[end].is("(") || tokens_[end].is("[") || tokens_[end].is("{")) {
        const auto close = closing_of(tokens_, end);
        if (!close) return std::nullopt;
        end = *close;
      }
      if (tokens_[end].is(";")) return end;
      if (tokens_[end].is("}")) return std::nullopt;
    }
    return std::nullopt;
  }

  void exchange_arms(std::size_t i) {
    if (!at(i, "?")) return;
    std::size_t colon = i + 1;
    for (int depth = 0; colon < tokens_.size(); ++colon) {
      if (at(colon, "(") || at(colon, "[") || at(colon, "{")) ++depth;
      if (at(colon, ")") || at(colon, "]") || at(colon, "}")) --depth;
      if (depth == 0 && at(colon, "?")) return;  // a chain of them
      if (depth == 0 && at(colon, ":")) break;
    }
    std::size_t end = colon + 1;
    for (int depth = 0; end < tokens_.size(); ++end) {
      if (at(end, "(") || at(end, "[") || at(end, "{")) ++depth;
      if (at(end, ")") || at(end, "]") || at(end, "}"))
        if (--depth < 0) break;
      if (depth == 0 && (at(end, ";") || at(end, ","))) break;
      if (depth == 0 && at(end, "?")) return;
    }
    if (end >= tokens_.size() || end == colon + 1) return;
    replace(TokenRange{i + 1, end}, text({colon + 1, end}) + " : " + text({i + 1, colon}), "arms");
  }

  // ---- Rewritings

  /// Whether the operand before `at` is all that stands on the left side of its sum or product.
  bool begins_expression(const TokenRange& left, bool product) const {
    if (left.begin == 0) return false;
    const Token& before = tokens_[left.begin - 1];
    if (before.kind != Kind::symbol) return before.is("return");
    for (const char* word : {"(", ",", "=", "{", "+=", "-=", "?", ":", "<", ">", "<=", ">=", "&&", "||", "[", ";"})
      if (before.is(word)) return true;
    return product && (before.is("+") || before.is("-")) && !is_unary(tokens_, left.begin - 1);
  }

  void turn_round(std::size_t i) {
    const Token& token = tokens_[i];
    if (token.kind != Kind::symbol || is_unary(tokens_, i)) return;
    const auto left = operand_before(tokens_, i), right = operand_behind(tokens_, i);
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
    if (const auto other = partner(turned_comparisons, token.text);
        other && begins_expression(*left, false) && ends_expression(right->end))
      replace(both, b + " " + std::string(*other) + " " + a, "comparison turned");
  }

  bool binds_tighter(std::size_t i) const { return at(i, "*") || at(i, "/") || at(i, "%"); }
  bool ends_expression(std::size_t i) const {
    return at(i, ")") || at(i, ";") || at(i, "&&") || at(i, "||") || at(i, "?") || at(i, ",");
  }

  void write_out(std::size_t i, bool glsl) {
    if (glsl && at(i, "/")) {
      const auto left = operand_before(tokens_, i), right = operand_behind(tokens_, i);
      if (left && right && begins_expression(*left, true))
        replace(TokenRange{left->begin, right->end}, text(*left) + " * (1.0 / (" + text(*right) + "))", "quotient");
    }
    if (glsl && at(i, "normalize") && at(i + 1, "(")) {
      const auto close = closing_of(tokens_, i + 1);
      const std::string v = close ? text({i + 2, *close}) : "";
      if (close) replace(TokenRange{i, *close + 1}, "((" + v + ") / length(" + v + "))", "normalize");
    }
    if ((at(i, "+=") || at(i, "*=")) && i > 0 && begins_statement(i - 1)) {
      if (const auto end = end_of_statement(i - 1)) {
        const std::string name(tokens_[i - 1].text);
        replace(TokenRange{i - 1, *end},
                name + " = " + name + " " + std::string(1, tokens_[i].text[0]) + " (" + text({i + 1, *end}) + ")",
                "written out");
      }
    }
    if (at(i, "if") && at(i + 1, "(")) {
      const auto close = closing_of(tokens_, i + 1);
      if (close && at(*close + 1, "return"))
        replace(TokenRange{i + 2, *close}, "(" + text({i + 2, *close}) + ") == true", "guard");
    }
    if (!glsl && at(i, "return") && i > 0 && (at(i - 1, ";") || at(i - 1, "}")) && !at(i + 1, "{") && !at(i + 1, ";"))
      if (const auto end = end_of_statement(i))
        replace(TokenRange{i, *end}, "auto the_result = " + text({i + 1, *end}) + "; return the_result", "temporary");
  }

  std::string_view text_;
  std::vector<Token> tokens_;
  std::vector<std::pair<std::size_t, std::size_t>> parts_;
  std::vector<Edit> edits_;
};

/// SplitMix64 (Steele, Lea, Flood, "Fast splittable pseudorandom number generators", 2014).
std::uint64_t next_random(std::uint64_t& state) {
  std::uint64_t z = state += 0x9e3779b97f4a7c15;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return z ^ (z >> 31);
}

/// What moves a result: for floats, vectors and matrices; everything else stays as it is.
constexpr const char* moving_functions = R"(
#include <bit>
#include <cstdint>
#include <glm/glm.hpp>
namespace moved_last_bits {
inline float moved(float x) {
  static std::uint32_t state = SEEDu;
  state = state * 1664525u + 1013904223u;
  if (!(x > 1e-30f || x < -1e-30f) || !(x - x == 0)) return x;  // 0 and what is not finite stay
  return std::bit_cast<float>(std::bit_cast<std::uint32_t>(x) + (state >> 16) % 3u - 1u);
}
template <int L, glm::qualifier Q>
glm::vec<L, float, Q> moved(glm::vec<L, float, Q> v) {
  for (int i = 0; i < L; ++i) v[i] = moved(v[i]);
  return v;
}
template <int C, int R, glm::qualifier Q>
glm::mat<C, R, float, Q> moved(glm::mat<C, R, float, Q> m) {
  for (int i = 0; i < C; ++i) m[i] = moved(m[i]);
  return m;
}
template <class T>
T moved(T other) {
  return other;
}
}  // namespace moved_last_bits
)";

}  // namespace

std::vector<Edit> mutations_of(std::string_view marked) {
  return Finder(marked).mutations();
}

std::vector<Edit> rewritings_of(std::string_view marked, bool glsl) {
  return Finder(marked).rewritings(glsl);
}

std::string edited(std::string_view text, std::vector<Edit> edits) {
  std::sort(edits.begin(), edits.end(), [](const Edit& a, const Edit& b) { return a.begin < b.begin; });
  std::string out;
  std::size_t at = 0;
  for (const Edit& edit : edits) {
    out += text.substr(at, edit.begin - at);
    out += edit.text;
    at = edit.end;
  }
  return out.append(text.substr(at));
}

std::vector<Edit> drawn(std::vector<Edit> edits, std::size_t count, std::uint64_t seed) {
  for (std::size_t i = edits.size(); i > 1; --i) std::swap(edits[i - 1], edits[next_random(seed) % i]);
  std::vector<Edit> taken;
  for (Edit& edit : edits) {
    const bool free = std::none_of(taken.begin(), taken.end(),
                                   [&](const Edit& other) { return edit.begin < other.end && other.begin < edit.end; });
    if (free && taken.size() < count) taken.push_back(std::move(edit));
  }
  return taken;
}

std::string with_moved_last_bits(std::string_view marked, std::uint64_t seed) {
  std::vector<Edit> edits;
  const std::vector<Token> tokens = tokens_of(marked);
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (!tokens[i].is("return") || i + 1 >= tokens.size() || tokens[i + 1].is(";") || tokens[i + 1].is("{")) continue;
    std::size_t end = i + 1;
    int depth = 0;
    for (; end < tokens.size() && !(depth == 0 && tokens[end].is(";")); ++end) {
      if (tokens[end].is("(") || tokens[end].is("{") || tokens[end].is("[")) ++depth;
      if (tokens[end].is(")") || tokens[end].is("}") || tokens[end].is("]")) --depth;
    }
    if (end >= tokens.size()) break;
    edits.push_back({tokens[i + 1].begin, tokens[i + 1].begin, "moved_last_bits::moved(", "moved"});
    edits.push_back({tokens[end].begin, tokens[end].begin, ")", "moved"});
  }
  std::string head = moving_functions;
  head.replace(head.find("SEED"), 4, std::to_string(seed % 4294967291u));
  return head + edited(marked, edits);
}

}  // namespace atelier
