#include "judge/compare/probe.hpp"

#include <cmath>
#include <limits>

#include "catch.hpp"
#include "judge/compare/verdict.hpp"
#include "synthetic.hpp"

namespace atelier::judge::test {
namespace {

using atelier::test::mentions;

TEST_CASE("a number is right within its absolute, relative or ulp tolerance") {
  struct Row {
    const char* name;
    double yours, expected;
    Tolerance tolerance;
    bool right;
  };
  const float next = std::nextafter(1.0f, 2.0f);
  const Row rows[]{
      {"equal, nothing tolerated", 0.1, 0.1, {}, true},
      {"nearly equal, nothing tolerated", 0.1, 0.1000001, {}, false},
      {"at the absolute border", 1.5, 1.0, {0.5, 0, 0, ""}, true},
      {"past it", 1.5625, 1.0, {0.5, 0, 0, ""}, false},
      {"relative", -1010, -1000, {0, 0.01, 0, ""}, true},
      {"relative to zero is nothing", 1e-9, 0, {0, 0.01, 0, ""}, false},
      {"both add up", 112, 100, {2, 0.1, 0, ""}, true},
      {"one float apart", double(next), 1.0, {0, 0, 1, ""}, true},
      {"two floats apart", double(std::nextafter(next, 2.0f)), 1.0, {0, 0, 1, ""}, false},
      {"floats across zero", 1e-45, -1e-45, {0, 0, 2, ""}, true},
      {"minus zero", -0.0, 0.0, {}, true},
      {"NaN for a number", nan, 1, {1e9, 1e9, 1 << 30, ""}, false},
      {"a number for NaN", 1, nan, {1e9, 1e9, 1 << 30, ""}, false},
      {"NaN for NaN", nan, nan, {}, true},
      {"infinity for infinity", infinity, infinity, {}, true},
      {"the other infinity", -infinity, infinity, {1e9, 0, 1 << 30, ""}, false},
      {"infinity for a number", infinity, 1, {0, 1, 1 << 30, ""}, false},
      {"a large number for infinity", 1e300, infinity, {0, 1, 1 << 30, ""}, false},
      {"beyond the range of floats", 1e300, 1e299, {0, 0, 4, ""}, false},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    CHECK(within(row.yours, row.expected, row.tolerance) == row.right);
    CHECK((times_tolerance(row.yours, row.expected, row.tolerance) <= 1) == row.right);
  }
}

JudgedCase probe_case() {
  JudgedCase c;
  c.ask.name = "normal-matrix";
  c.ask.probe = "normal_matrix";
  c.profile = Profile::values;
  c.points = 4;
  c.tolerance = {1e-4, 0, 0, "a few roundings"};
  for (double x : {1.0, 2.0, 3.0, 4.0}) {
    Arguments input;
    input.values["x"] = {x};
    c.ask.inputs.push_back(input);
  }
  c.expected = {{1, 1}, {2, 4}, {3, 9}, {4, 16}};
  return c;
}

StepReferences references_of(const JudgedCase& c) {
  StepReferences references("01-transforms");
  CaseReferences right;
  right.values = c.expected;
  references.add(c.ask.name, right,
                 {{}, {.mistakes = {{"no-square", {{1, 1}, {2, 2}, {3, 3}, {4, 4}}}}, .unwritten = {}}});
  return references;
}

TEST_CASE("probes: every input within the tolerance passes; one that is not fails") {
  const JudgedCase c = probe_case();
  const StepReferences references = references_of(c);
  struct Row {
    const char* name;
    std::vector<Numbers> yours;
    Status status;
    double score;
    std::vector<std::string_view> words;
  };
  const std::vector<Row> rows{
      {"equal", c.expected, Status::passed, 4, {"all 4 inputs"}},
      {"within", {{1, 1.00005}, {2, 4}, {3, 9}, {4, 16}}, Status::passed, 4, {"0.5 of the tolerance"}},
      {"one wrong",
       {{1, 1}, {2, 4}, {3, 9.5}, {4, 16}},
       Status::failed,
       4 * 0.7,
       {"1 of 4 inputs", "First error at input 2: number 2 of 2 is 9.5 instead of 9."}},
      {"three wrong",
       {{0, 1}, {2, 4}, {3, 9.5}, {4, 19}},
       Status::failed,
       4 * 0.25,
       {"3 of 4 inputs", "First error at input 0: number 1 of 2", "worst error at input 3: number 2 of 2 is 19"}},
      {"all wrong", {{0, 0}, {0, 0}, {0, 0}, {0, 0}}, Status::failed, 0, {"all 4 inputs"}},
      {"a NaN", {{1, 1}, {2, nan}, {3, 9}, {4, 16}}, Status::failed, 4 * 0.7, {"input 1", "NaN or infinity"}},
      {"too few results", {{1, 1}}, Status::failed, 0, {"1 results", "4 inputs"}},
      {"too few numbers", {{1, 1}, {2}, {3, 9}, {4, 16}}, Status::failed, 0, {"input 1", "1 numbers", "2"}},
      {"no results", {}, Status::failed, 0, {"0 results"}},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    const CaseResult result = judge_case(c, answer_of(row.yours), references);
    CHECK(result.status == row.status);
    CHECK(result.score == Approx(row.score));
    CHECK(result.credit.empty() == (row.score == 0 || row.score == 4));
    INFO(result.reason);
    for (std::string_view word : row.words) CHECK(mentions(result.reason, {word}));
    CHECK_FALSE(result.evidence.has_value());
  }
  const CaseResult named = judge_case(c, answer_of({{1, 1}, {2, 2}, {3, 3}, {4, 4}}), references);
  CHECK(named.could_be == std::vector<std::string>{"no-square"});
  CHECK(judge_case(c, answer_of(Image(8, 8)), references).status == Status::missing);
}

TEST_CASE("probes: the table shows the worst input first") {
  const JudgedCase c = probe_case();
  const std::string table = probe_table({{1, 1}, {2, 5}, {3, 90}, {4, 16}}, c.expected, c, 2);
  CHECK(table.find("input 2: wrong") < table.find("input 1: wrong"));
  CHECK(mentions(table, {"x         3", "expected  (3, 9)", "yours     (3, 90)", "and 2 more inputs"}));
  CHECK(table.find("input 0") == std::string::npos);
  CHECK(mentions(probe_table(c.expected, c.expected, c), {"input 0: equal", "input 3: equal"}));
}

Numbers counting(std::size_t count) {
  Numbers numbers(count);
  for (std::size_t k = 0; k < count; ++k) numbers[k] = double(k);
  return numbers;
}

Numbers identity() {
  return {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
}

TEST_CASE("numbers are a matrix if every answer is one") {
  Numbers two = identity();
  two.insert(two.end(), 16, 0);
  two.back() = 1;
  struct Row {
    const char* name;
    std::vector<Numbers> expected;
    int side;
  };
  const Row rows[]{
      {"sixteen", {counting(16), identity()}, 4},
      {"nine", {counting(9)}, 3},
      {"several, all affine", {two, identity()}, 4},
      {"thirty-two numbers that are no matrices", {counting(32)}, 0},
      {"sixteen and others", {counting(8), counting(16), counting(20)}, 0},
      {"a vector", {{1, 2, 3}}, 0},
      {"no numbers", {{}}, 0},
      {"no inputs", {}, 0},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    CHECK(matrix_side(row.expected) == row.side);
  }
}

TEST_CASE("an entry's row and column are those of the handouts and glm") {
  const auto place = [](int component, std::size_t count) {
    return place_of_number({.input = 0, .component = component}, {Numbers(count)}, JudgedCase());
  };
  CHECK(place(12, 16) == "row 1, column 4 (m[3][0])");
  CHECK(place(3, 16) == "row 4, column 1 (m[0][3])");
  CHECK(place(5, 9) == "row 3, column 2 (m[1][2])");
  CHECK(place(1, 3) == "number 2 of 3");
  CHECK(place(0, 1).empty());
  const std::vector<Numbers> matrices{
      {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}};
  CHECK(place_of_number({.input = 0, .component = 16}, matrices, JudgedCase()) ==
        "row 1, column 1 (m[0][0]) of matrix 2 of 2");
}

TEST_CASE("numbers with names are called by them, enums of OpenGL too") {
  JudgedCase c = probe_case();
  c.tolerance = {};
  c.numbers = {{.name = "eye.x"}, {.name = "filter", .is_enum = true}};
  c.expected = {{1, 9728}, {2, 9729}, {3, 9729}, {4, 0}};
  StepReferences references("01-transforms");
  CaseReferences right;
  right.values = c.expected;
  references.add(c.ask.name, right);
  const CaseResult result =
      judge_case(c, answer_of(std::vector<Numbers>{{1, 9729}, {2.00000001, 9729}, {3, 4660}, {4, 0}}), references);
  CHECK(mentions(result.reason, {"filter is GL_LINEAR instead of GL_NEAREST"}));
  CHECK(mentions(result.table, {"  eye.x: 2.00000001 instead of 2\n", "  filter: 0x1234 instead of GL_LINEAR\n"}));
  CHECK(result.table.find("eye.x: 1") == std::string::npos);
}

TEST_CASE("a matrix is shown by its rows, without signed zeros and without noise") {
  const std::string shown = show_matrices(counting(16), 4);
  CHECK(mentions(shown.substr(0, shown.find('\n')), {" 0 ", " 4 ", " 8 ", " 12 "}));
  CHECK(std::count(shown.begin(), shown.end(), '\n') == 3);
  CHECK(std::count(shown.begin(), shown.end(), '[') == 4);
  const Numbers noisy{1, -0.0, 3e-8, -3e-8, 1e-6, 1, 0, 0, 1};
  CHECK(show_matrices(noisy, 3, 1e-6) ==
        "[            1             0             0 ]\n"
        "[            0         1e-06             0 ]\n"
        "[            0             1             1 ]");
  CHECK(mentions(show_matrices(noisy, 3), {"-3e-08"}));
  CHECK(show_numbers({1.5}) == "1.5");
  CHECK(show_numbers({-0.0}) == "0");
  CHECK(show_numbers({-0.0, 1.5, -2}) == "(0, 1.5, -2)");
}

TEST_CASE("the table shows a matrix as a matrix") {
  JudgedCase c;
  c.profile = Profile::values;
  c.tolerance = {1e-6, 0, 0, "a few roundings"};
  c.ask.inputs.resize(1);
  c.ask.inputs[0].values["model"] = identity();
  Numbers yours = identity();
  yours[12] = 5;
  yours[1] = -1e-9;
  const std::string table = probe_table({yours}, {identity()}, c);
  CHECK(mentions(table, {"model", "[            1             0             0             5 ]"}));
  CHECK(table.find("-1e-09") == std::string::npos);
}

}  // namespace
}  // namespace atelier::judge::test
