// Changes of solutions by machine: which there are, and that they are what they say.
#include "cli/author/mutations.hpp"

#include <algorithm>
#include <set>

#include "catch.hpp"
#include "cli/author/code_tokens.hpp"
#include "cli/author/last_bits.hpp"
#include "cli/author/rewritings.hpp"

using namespace atelier;

namespace {

std::string marked(const std::string& line) {
  return "float f(float a, float b) {\n  // >>> student: do it\n  " + line +
         "\n  // --- skeleton\n  // | return 0.0 + 1.0;\n  // <<< student\n}\nfloat given() { return 1.0 + 2.0; }\n";
}

/// What `edits` make of the line, each by itself.
std::set<std::string> lines_of(const std::string& line, const std::vector<Edit>& edits) {
  std::set<std::string> lines;
  const std::string text = marked(line);
  for (const Edit& edit : edits) {
    const std::string changed = edited(text, {edit});
    const std::size_t begin = changed.find("do it\n  ") + 8;
    lines.insert(changed.substr(begin, changed.find("\n  // --- skeleton") - begin));
  }
  return lines;
}

std::set<std::string> mutated(const std::string& line) {
  return lines_of(line, mutations_of(marked(line)));
}

}  // namespace

TEST_CASE("tokens pass over comments, strings and preprocessor lines") {
  const std::string text = "#include <a>\nx += 1.5e-3f; // y\n\"s\" /* z */ 'c' a->b::c[2]";
  std::vector<std::string> words;
  for (const Token& token : tokens_of(text)) {
    words.emplace_back(token.text);
    CHECK(text.substr(token.begin, token.text.size()) == token.text);
  }
  CHECK(words == std::vector<std::string>{"x", "+=", "1.5e-3f", ";", "a", "->", "b", "::", "c", "[", "2", "]"});
}

TEST_CASE("operands are names with all that belongs to them, numbers and brackets") {
  struct Row {
    const char *text, *before, *behind;
  };
  for (const Row& row : {Row{"return a.b(c)[1] * -glm::dot(x, y).z + 2;", "a.b(c)[1]", "-glm::dot(x, y).z"},
                         Row{"x = (a + b) * (c - d);", "(a + b)", "(c - d)"}, Row{"f(-a * 2.0f)", "-a", "2.0f"}}) {
    const std::vector<Token> tokens = tokens_of(row.text);
    const auto at = std::find_if(tokens.begin(), tokens.end(), [](const Token& t) { return t.is("*"); });
    const auto i = std::size_t(at - tokens.begin());
    INFO(row.text);
    REQUIRE((operand_before(tokens, i) && operand_behind(tokens, i)));
    CHECK(text_of(row.text, tokens, *operand_before(tokens, i)) == row.before);
    CHECK(text_of(row.text, tokens, *operand_behind(tokens, i)) == row.behind);
    CHECK_FALSE(is_unary(tokens, i));
  }
}

TEST_CASE("each kind of mutation is made, and only in what a student writes") {
  struct Row {
    const char* line;
    std::vector<const char*> among;
  };
  const std::vector<Row> rows = {
      {"return a + b;", {"return a - b;", "return a ;"}},
      {"return -a;", {"return a;"}},
      {"return a * 2.0;", {"return a / 2.0;", "return a ;", "return a * (2.0 * 2.0);"}},
      {"return max(a, 0.0);", {"return min(a, 0.0);", "return (a);", "return max(a, 1.0);"}},
      {"return mix(a, b, 0.5);", {"return mix(b, a, 0.5);", "return mix(a, 0.5, b);"}},
      {"return glm::normalize(v);", {"return (v);"}},
      {"if (a < b) return a;", {"if (a <= b) return a;", "if (a > b) return a;", "if (false) return a;"}},
      {"return v.xy;", {"return v.yx;"}},
      {"return v.x;", {"return v.y;"}},
      {"return view * model;", {"return model * view;"}},
      {"return a > b ? a : b;", {"return a > b ? b : a;"}},
      {"gl.Enable(GL_DEPTH_TEST);", {"gl.Enable(GL_CULL_FACE);", "gl.Disable(GL_DEPTH_TEST);", ";"}},
      {"for (int i = 0; i < n; ++i) s += i;",
       {"for (int i = 1; i < n; ++i) s += i;", "for (int i = 0; i <= n; ++i) s += i;",
        "for (int i = 0; i < n; ++i) s -= i;", "for (int i = 0; i < n; ++i) ;"}},
  };
  for (const Row& row : rows) {
    const std::set<std::string> made = mutated(row.line);
    INFO(row.line);
    for (const char* expected : row.among) {
      INFO(expected);
      CHECK(made.contains(expected));
    }
    CHECK_FALSE(made.contains(row.line));  // none of them outside: not in the skeleton's lines, not in given code
  }
  CHECK_FALSE(mutated("return dot(a, b);").contains("return dot(b, a);"));  // the same number
  CHECK(mutated("std::vector<float> v;").empty());
  CHECK_FALSE(mutated("const float c = a;").contains(";"));  // a declaration is no statement to leave out
}

TEST_CASE("other forms have the same meaning") {
  const auto forms = [](const std::string& line, bool glsl) {
    return lines_of(line, rewritings_of(marked(line), glsl));
  };
  CHECK(forms("return a + b;", true) == std::set<std::string>{"return b + a;"});
  CHECK(forms("return a + b * c;", true) == std::set<std::string>{"return a + c * b;"});  // never b + a * c
  CHECK(forms("return a - b;", true) == std::set<std::string>{"return a + (-(b));"});
  CHECK(forms("return a / b;", true) == std::set<std::string>{"return a * (1.0 / (b));"});
  CHECK(forms("return a / b;", false).empty());  // it may be of whole numbers
  CHECK(forms("return view * model;", true).empty());
  CHECK(forms("return frame_of(n, t) * v;", true).empty());
  CHECK(forms("if (a < b) return a;", true).contains("if (b > a) return a;"));
  CHECK(forms("c = 1.0; return c * a;", false).contains("c = 1.0; auto the_result = c * a; return the_result;"));
}

TEST_CASE("a sample depends on its seed alone, and does not overlap") {
  const std::string text = marked("return a + b * c - d / e + f(a * 2.0, b);");
  const std::vector<Edit> all = mutations_of(text);
  std::set<std::string> texts;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    std::vector<Edit> some = sampled(all, 3, seed);
    CHECK(some.size() == 3);
    texts.insert(edited(text, some));
    CHECK(edited(text, some) == edited(text, sampled(all, 3, seed)));
    std::sort(some.begin(), some.end(), [](const Edit& a, const Edit& b) { return a.begin < b.begin; });
    for (std::size_t i = 1; i < some.size(); ++i) CHECK(some[i - 1].end <= some[i].begin);
  }
  CHECK(texts.size() > 5);
}

TEST_CASE("results are moved where a value is returned") {
  const std::string moved =
      with_moved_last_bits("float f() { return g(1, {2}); }\nM h() { return {1}; }\nvoid k() { return; }\n", 7);
  CHECK(moved.find("return moved_last_bits::moved(g(1, {2}));") != moved.npos);
  CHECK(moved.find("return {1};") != moved.npos);
  CHECK(moved.find("return;") != moved.npos);
  CHECK(moved.find("state = 7u") != moved.npos);
}
