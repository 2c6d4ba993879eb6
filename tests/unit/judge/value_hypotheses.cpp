// Whole-value hypotheses: each operation is found on numbers that it was applied to, and on no others.
#include "judge/explain/value_hypotheses.hpp"

#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <numbers>

#include "catch.hpp"
#include "judge/compare/verdict.hpp"
#include "synthetic.hpp"

namespace atelier::judge::test {
namespace {

using atelier::test::mentions;
using Matrix = glm::dmat4;

JudgedCase case_of(std::size_t inputs) {
  JudgedCase c;
  c.ask.name = "matrix";
  c.ask.probe = "place";
  c.profile = Profile::values;
  c.points = 1;
  c.tolerance = {2e-6, 0, 0, "a few roundings"};
  c.ask.inputs.resize(inputs);
  return c;
}

/// As a student's single precision would return it.
Numbers numbers(const Matrix& m) {
  Numbers columns;
  for (int k = 0; k < 16; ++k) columns.push_back(double(float(m[k / 4][k % 4])));
  return columns;
}

/// Two matrices that no operation leaves as they are.
std::vector<Matrix> places() {
  const Matrix one = glm::rotate(glm::translate(Matrix(1), {1, -2, 3.5}), 0.7, {0.6, 0.0, 0.8});
  const Matrix two = glm::scale(glm::translate(Matrix(1), {-4, 0.25, 9}), {2, 3, 0.5});
  return {one, two};
}

std::vector<Numbers> listed(const std::vector<Matrix>& matrices) {
  std::vector<Numbers> list;
  for (const Matrix& m : matrices) list.push_back(numbers(m));
  return list;
}

template <class Change>
std::vector<Numbers> changed_matrices(std::vector<Matrix> matrices, Change change) {
  for (Matrix& m : matrices) m = change(m);
  return listed(matrices);
}

std::optional<Hypothesis> explained(const std::vector<Numbers>& yours, const std::vector<Numbers>& expected) {
  return explain_values(yours, expected, case_of(expected.size()));
}

struct ValueRow {
  const char* name;
  std::vector<Numbers> yours;
  const char* words;
};

void check_value_rows(const std::vector<ValueRow>& rows, const std::vector<Numbers>& expected) {
  for (const ValueRow& row : rows) {
    INFO(row.name << ": " << row.words);
    const auto found = explained(row.yours, expected);
    REQUIRE(found.has_value());
    INFO(found->sentence);
    CHECK(found->name == row.name);
    CHECK(found->sentence == "place returns " + std::string(row.words) + ".");
    CHECK_FALSE(found->hint.empty());
  }
}

TEST_CASE("matrices: transpose, inverse, signs, exchanges, a factor and a constant are found") {
  const std::vector<Matrix> right = places();
  const auto row_negated = [](Matrix m) {
    for (int column = 0; column < 4; ++column) m[column][2] = -m[column][2];
    return m;
  };
  const auto rows_exchanged = [](Matrix m) {
    for (int column = 0; column < 4; ++column) std::swap(m[column][1], m[column][2]);
    return m;
  };
  const auto column_negated = [](Matrix m) {
    m[3] = -m[3];
    return m;
  };
  const auto columns_exchanged = [](Matrix m) {
    std::swap(m[0], m[3]);
    return m;
  };
  const auto times = [](double factor) { return [=](const Matrix& m) { return m * factor; }; };
  check_value_rows(
      {
          {"transposed", changed_matrices(right, [](const Matrix& m) { return glm::transpose(m); }),
           "the right matrix transposed"},
          {"inverse", changed_matrices(right, [](const Matrix& m) { return glm::inverse(m); }),
           "the inverse of the right matrix"},
          {"inverse-transpose",
           changed_matrices(right, [](const Matrix& m) { return glm::transpose(glm::inverse(m)); }),
           "the inverse transpose of the right matrix"},
          {"negated", changed_matrices(right, times(-1)), "the right numbers with the wrong sign"},
          {"negated-row", changed_matrices(right, row_negated), "the right matrix with its third row negated"},
          {"negated-column", changed_matrices(right, column_negated),
           "the right matrix with its fourth column negated"},
          {"swapped-rows", changed_matrices(right, rows_exchanged),
           "the right matrix with its second and third row exchanged"},
          {"swapped-columns", changed_matrices(right, columns_exchanged),
           "the right matrix with its first and fourth column exchanged"},
          {"gain", changed_matrices(right, times(2)), "2 times the right numbers (2)"},
          {"gain", changed_matrices(right, times(std::numbers::pi / 180)), "0.01745 times the right numbers (pi/180)"},
          {"gain", changed_matrices(right, times(1.7)), "1.7 times the right numbers"},
          {"offset", changed_matrices(right, [](const Matrix& m) { return m + 0.5; }),
           "the right numbers, each too large by 0.5"},
      },
      listed(right));
}

TEST_CASE("matrices of nine numbers, and lists of matrices, are explained alike") {
  const Numbers right{1, 2, 3, 4, 5, 6, 7, 8, 10}, transposed{1, 4, 7, 2, 5, 8, 3, 6, 10};
  CHECK(explained({transposed}, {right}).value().name == "transposed");

  // The first of three is right: it equals its transpose, and the others prove it.
  std::vector<Matrix> chain = places();
  chain.insert(chain.begin(), Matrix(1));
  Numbers expected, yours;
  for (const Matrix& m : chain) {
    for (double x : numbers(m)) expected.push_back(x);
    for (double x : numbers(glm::transpose(m))) yours.push_back(x);
  }
  const auto found = explained({yours}, {expected});
  REQUIRE(found.has_value());
  CHECK(found->sentence == "place returns the right matrix transposed.");

  // The first of three is right, and does not equal its transpose.
  for (std::size_t k = 12; k < 15; ++k) expected[k] = yours[k] = 5;
  CHECK(explained({yours}, {expected}).value().sentence ==
        "Where it is wrong, place returns the right matrix transposed.");
}

TEST_CASE("vectors: signs, exchanges, lengths, factors and the place of w are found") {
  const std::vector<Numbers> units{{0.48, 0.6, 0.64}, {0, -0.6, 0.8}, {2 / 3.0, 1 / 3.0, -2 / 3.0}};
  check_value_rows(
      {
          {"negated",
           {{-0.48, -0.6, -0.64}, {0, 0.6, -0.8}, {-2 / 3.0, -1 / 3.0, 2 / 3.0}},
           "the right numbers with the wrong sign"},
          {"negated-component",
           {{0.48, 0.6, -0.64}, {0, -0.6, -0.8}, {2 / 3.0, 1 / 3.0, 2 / 3.0}},
           "the right numbers with the third negated"},
          {"swapped-components",
           {{0.6, 0.48, 0.64}, {-0.6, 0, 0.8}, {1 / 3.0, 2 / 3.0, -2 / 3.0}},
           "the right numbers with the first and the second exchanged"},
          {"not-normalised", {{4.8, 6, 6.4}, {0, -0.3, 0.4}, {2, 1, -2}}, "the right direction, not normalised"},
      },
      units);

  check_value_rows({{"normalised", {{0.6, 0.8}, {-0.8, 0.6}}, "the right direction, normalised"}}, {{3, 4}, {-8, 6}});
  check_value_rows({{"w-first", {{4, 1, 2, 3}}, "the right numbers in the order w, x, y, z instead of x, y, z, w"},
                    {"w-last", {{2, 3, 4, 1}}, "the right numbers in the order x, y, z, w instead of w, x, y, z"}},
                   {{1, 2, 3, 4}});
}

TEST_CASE("single numbers: a factor and a constant are found over several inputs") {
  const std::vector<Numbers> right{{0.1}, {0.4}, {0.9}, {0}};
  check_value_rows({{"gain", {{0.05}, {0.2}, {0.45}, {0}}, "0.5 times the right numbers (1/2)"},
                    {"gain",
                     {{18 / std::numbers::pi}, {72 / std::numbers::pi}, {162 / std::numbers::pi}, {0}},
                     "57.3 times the right numbers (180/pi)"},
                    {"offset", {{-0.9}, {-0.6}, {-0.1}, {-1}}, "the right numbers, each too small by 1"}},
                   right);
}

TEST_CASE("a float's precision where doubles are asked is said, and no constant is made of it") {
  JudgedCase c = case_of(2);
  c.tolerance = {1e-9, 0, 0, "doubles"};
  const std::vector<Numbers> expected = {{1000.123456789, -3.14159265358979}, {0.1, 700.000000017}};
  std::vector<Numbers> floats = expected, shifted = expected, far_off = expected;
  for (Numbers& row : floats)
    for (double& x : row) x = double(float(x));
  for (Numbers& row : shifted)
    for (double& x : row) x -= 4.371e-8;
  for (Numbers& row : far_off)
    for (double& x : row) x -= 0.5;
  CHECK(explain_values(floats, expected, c)->name == "float-precision");
  CHECK(explain_values(shifted, expected, c)->name == "float-precision");
  CHECK(explain_values(far_off, expected, c)->name == "offset");
  c.tolerance = {1e-3, 0, 0, "floats"};  // as exact as the case asks: it is something else
  std::vector<Numbers> wrong = expected;
  wrong[0][0] += 0.002;
  const auto other = explain_values(wrong, expected, c);
  CHECK((!other || other->name != "float-precision"));
}

TEST_CASE("equally good explanations are listed") {
  const Matrix turn = glm::rotate(Matrix(1), 0.7, {0.6, 0.0, 0.8});
  const auto found = explained({numbers(glm::transpose(turn))}, {numbers(turn)});
  REQUIRE(found.has_value());
  CHECK(found->name == "transposed");
  CHECK(mentions(found->sentence, {"transposed, which here is also the inverse of the right matrix."}));
}

TEST_CASE("weak or incomplete explanations are not given") {
  const Numbers symmetric = numbers(glm::scale(Matrix(1), {2, 3, 4}));
  Numbers other = symmetric;
  other[12] = 1, other[13] = 2;
  Numbers almost = numbers(glm::transpose(places()[0]));
  almost[0] += 0.001;
  Numbers singular = numbers(glm::scale(Matrix(1), {1, 1, 0}));
  const std::vector<std::pair<const char*, std::pair<std::vector<Numbers>, std::vector<Numbers>>>> rows{
      {"a symmetric matrix", {{other}, {symmetric}}},
      {"transposed but for one entry", {{almost}, {numbers(places()[0])}}},
      {"transposed for one input only", {{numbers(glm::transpose(places()[0])), other}, listed(places())}},
      {"NaN for a matrix without inverse", {{Numbers(16, nan)}, {singular}}},
      {"NaN", {{{nan, nan, nan}}, {{1, 2, 3}}}},
      {"one number of one input", {{{0, 0, -5}}, {{0, 0, 5}}}},
      {"a factor of one number", {{{2}}, {{1}}}},
      {"yes for no, every time", {{{0}, {0}, {0}, {0}}, {{1}, {1}, {1}, {1}}}},
      {"zeros", {{{0, 0, 0}, {0, 0, 0}}, {{1, 2, 3}, {4, 5, 6}}}},
      {"all equal", {{{1, 2, 3}}, {{1, 2, 3}}}},
  };
  for (const auto& [name, lists] : rows) {
    INFO(name);
    const auto found = explained(lists.first, lists.second);
    INFO((found ? found->sentence : ""));
    CHECK_FALSE(found.has_value());
  }
}

TEST_CASE("a verdict starts with the hypothesis, then the first wrong entry") {
  JudgedCase c = case_of(2);
  c.expected = listed(places());
  StepReferences references("01-transforms");
  CaseReferences right;
  right.values = c.expected;
  references.add(c.ask.name, right);
  const auto yours = changed_matrices(places(), [](const Matrix& m) { return glm::transpose(m); });
  const CaseResult result = judge_case(c, answer_of(yours), references);
  CHECK(result.hypothesis == "transposed");
  INFO(result.reason);
  CHECK(result.reason.starts_with("place returns the right matrix transposed. place is wrong for all 2 inputs."));
  CHECK(
      mentions(result.reason, {"First error at input 0: row 2, column 1 (m[0][1]) is", "worst error at input 1: row"}));
  CHECK(mentions(result.hint, {"m[3] is the fourth column"}));
}

}  // namespace
}  // namespace atelier::judge::test
