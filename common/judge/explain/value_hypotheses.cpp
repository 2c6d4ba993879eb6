#include "judge/explain/value_hypotheses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/glm.hpp>
#include <limits>
#include <string>
#include <utility>

#include "judge/compare/probe.hpp"
#include "judge/explain/sentences.hpp"

namespace atelier::judge {
namespace {

constexpr int min_evidence = 2;        // numbers that the operation must change
constexpr double rounding = 4e-6;      // of the largest number: an inverse has larger rounding errors
constexpr double as_good = 0.1;        // tolerances: operations that differ by less fit equally well
constexpr double unit_within = 1e-3;   // allowed error of a unit vector's length
constexpr double name_within = 1e-4;   // allowed relative error of a known factor
constexpr double least_change = 0.02;  // a factor nearer to 1 or -1 is hardly a forgotten one
constexpr std::array ordinals{"first", "second", "third", "fourth"};

/// A returned value and the expected one.
struct Value {
  Numbers yours, expected;
};

struct Operation {
  std::string name, what, hint;  ///< `what` completes "FUNCTION returns ..."
  std::function<Numbers(const Value&)> apply;
  // How many numbers a parameter of the operation was derived from; these are no evidence.
  int taken = 0;           ///< in total
  int taken_of_value = 0;  ///< in each value
};

// --- Values ---

/// Splits results into values: matrices of `side` rows, or if `side` is 0, all numbers of each input.
std::vector<Value> values_of(const std::vector<Numbers>& yours, const std::vector<Numbers>& expected, int side) {
  std::vector<Value> values;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const std::size_t size = side > 0 ? std::size_t(side * side) : expected[i].size();
    for (std::size_t at = 0; at < expected[i].size(); at += size) {
      const auto part = [&](const Numbers& of) {
        return Numbers(of.begin() + std::ptrdiff_t(at), of.begin() + std::ptrdiff_t(at + size));
      };
      values.push_back({part(yours[i]), part(expected[i])});
    }
  }
  return values;
}

bool is_right(const Value& value, const Tolerance& tolerance) {
  return std::equal(value.yours.begin(), value.yours.end(), value.expected.begin(),
                    [&](double a, double b) { return within(a, b, tolerance); });
}

double length(const Numbers& numbers) {
  double square = 0;
  for (double x : numbers) square += x * x;
  return std::sqrt(square);
}

Numbers scaled(Numbers numbers, double factor) {
  for (double& x : numbers) x *= factor;
  return numbers;
}

/// The numbers in another order: element n is numbers[of(n)].
Numbers reordered(const Numbers& numbers, const std::function<std::size_t(std::size_t)>& of) {
  Numbers result;
  for (std::size_t n = 0; n < numbers.size(); ++n) result.push_back(numbers[of(n)]);
  return result;
}

// --- Matrices, as their columns ---

/// A 3x3 matrix fills the upper left of the identity.
glm::dmat4 matrix_of(const Numbers& columns, int side) {
  glm::dmat4 m(1);
  for (int k = 0; k < side * side; ++k) m[k / side][k % side] = columns[std::size_t(k)];
  return m;
}

Numbers columns_of(const glm::dmat4& m, int side) {
  Numbers columns;
  for (int k = 0; k < side * side; ++k) columns.push_back(m[k / side][k % side]);
  return columns;
}

void add_matrices(std::vector<Operation>& all, int side) {
  const auto whole = [&](const char* name, const char* what, const char* hint, auto change) {
    all.push_back(
        {name, what, hint, [=](const Value& v) { return columns_of(change(matrix_of(v.expected, side)), side); }});
  };
  whole("transposed", "the right matrix transposed",
        "Rows and columns are exchanged: m[3] is the fourth column, and a constructor fills the first column first.",
        [](const glm::dmat4& m) { return glm::transpose(m); });
  whole("inverse", "the inverse of the right matrix",
        "Which space does the matrix transform from, and to which? A wrong sign of an angle or offset also inverts it.",
        [](const glm::dmat4& m) { return glm::inverse(m); });
  whole("inverse-transpose", "the inverse transpose of the right matrix",
        "Normals need the inverse transpose; points and directions need the matrix itself.",
        [](const glm::dmat4& m) { return glm::transpose(glm::inverse(m)); });

  // Number k is in column k / side and row k % side.
  const auto row = [=](std::size_t k) { return int(k) % side; };
  const auto column = [=](std::size_t k) { return int(k) / side; };
  const auto lines = [&](const char* word, auto line_of, int step) {
    for (int a = 0; a < side; ++a) {
      all.push_back({fmt::format("negated-{}", word),
                     fmt::format("the right matrix with its {} {} negated", ordinals[std::size_t(a)], word),
                     "Look for one sign: a negated axis, or the order of the factors of a cross product.",
                     [=](const Value& v) {
                       Numbers numbers = v.expected;
                       for (std::size_t k = 0; k < numbers.size(); ++k)
                         if (line_of(k) == a) numbers[k] = -numbers[k];
                       return numbers;
                     }});
      for (int b = a + 1; b < side; ++b)
        all.push_back({fmt::format("swapped-{}s", word),
                       fmt::format("the right matrix with its {} and {} {} exchanged", ordinals[std::size_t(a)],
                                   ordinals[std::size_t(b)], word),
                       "Look for two axes, or two indices, in the wrong order.", [=](const Value& v) {
                         return reordered(v.expected, [&](std::size_t k) {
                           const int other = line_of(k) == a ? b - a : line_of(k) == b ? a - b : 0;
                           return std::size_t(int(k) + step * other);
                         });
                       }});
    }
  };
  lines("row", row, 1);
  lines("column", column, side);
}

// --- Two to four numbers ---

void add_vectors(std::vector<Operation>& all, std::size_t size) {
  for (std::size_t a = 0; a < size; ++a)
    for (std::size_t b = a; b < size; ++b) {
      if (a == b)
        all.push_back({"negated-component", fmt::format("the right numbers with the {} negated", ordinals[a]),
                       "Look for one sign: a negated axis, or the order of the factors of a cross product.",
                       [=](const Value& v) {
                         Numbers numbers = v.expected;
                         numbers[a] = -numbers[a];
                         return numbers;
                       }});
      else
        all.push_back({"swapped-components",
                       fmt::format("the right numbers with the {} and the {} exchanged", ordinals[a], ordinals[b]),
                       "Look for two axes, or two arguments, in the wrong order.", [=](const Value& v) {
                         return reordered(v.expected, [&](std::size_t k) { return k == a ? b : k == b ? a : k; });
                       }});
    }
  if (size == 4) {
    const char* const hint = "The contract says the order of the four numbers; many texts put a quaternion's w first.";
    all.push_back({"w-first", "the right numbers in the order w, x, y, z instead of x, y, z, w", hint,
                   [](const Value& v) { return reordered(v.expected, [](std::size_t k) { return (k + 3) % 4; }); }});
    all.push_back({"w-last", "the right numbers in the order x, y, z, w instead of w, x, y, z", hint,
                   [](const Value& v) { return reordered(v.expected, [](std::size_t k) { return (k + 1) % 4; }); }});
  }
  all.push_back({"not-normalised", "the right direction, not normalised", "Divide the direction by its length.",
                 [](const Value& v) {
                   const bool unit = std::abs(length(v.expected) - 1) < unit_within;
                   return unit ? scaled(v.expected, length(v.yours)) : v.expected;
                 },
                 0, 1});
  all.push_back({"normalised", "the right direction, normalised", "The length matters here: do not divide by it.",
                 [](const Value& v) {
                   return length(v.expected) > 0 ? scaled(v.expected, 1 / length(v.expected)) : v.expected;
                 }});
}

// --- Any numbers ---

/// Whether the expected numbers have different absolute values: a constant would fit any factor and any offset.
bool vary(const std::vector<Value>& values) {
  const double first = std::abs(values.front().expected.front());
  for (const Value& value : values)
    for (double x : value.expected)
      if (x != 0 && std::abs(std::abs(x) - first) > rounding * std::max(first, std::abs(x))) return true;
  return false;
}

void add_factor(std::vector<Operation>& all, const std::vector<Value>& values) {
  double expected = 0, yours = 0;  // at the largest number, where rounding matters least
  for (const Value& value : values)
    for (std::size_t k = 0; k < value.expected.size(); ++k)
      if (std::abs(value.expected[k]) > std::abs(expected)) expected = value.expected[k], yours = value.yours[k];
  const double factor = yours / expected;
  if (!std::isfinite(factor) || factor == 0 || std::abs(std::abs(factor) - 1) < least_change) return;
  const std::string name = factor_name(factor, name_within);
  const bool angle = name == "pi/180" || name == "180/pi";
  all.push_back({"gain", fmt::format("{:.4g} times the right numbers{}", factor, name.empty() ? "" : " (" + name + ")"),
                 angle ? "An angle is converted between degrees and radians twice, or not at all."
                       : "Look for a factor that is missing or applied twice.",
                 [=](const Value& v) { return scaled(v.expected, factor); }, name.empty() ? 1 : 0});
}

void add_constant(std::vector<Operation>& all, const std::vector<Value>& values) {
  const double constant = values.front().yours.front() - values.front().expected.front();
  all.push_back(
      {"offset",
       fmt::format("the right numbers, each too {} by {:.4g}", constant > 0 ? "large" : "small", std::abs(constant)),
       "Look for a constant that is missing or added twice: an index that starts at 1, a half pixel.",
       [=](const Value& v) {
         Numbers numbers = v.expected;
         for (double& x : numbers) x += constant;
         return numbers;
       },
       1});
}

std::vector<Operation> operations_for(const std::vector<Value>& values, int side) {
  const std::size_t size = values.front().expected.size();
  const bool alike =
      std::all_of(values.begin(), values.end(), [&](const Value& v) { return v.expected.size() == size; });
  std::vector<Operation> all;
  if (side > 0) add_matrices(all, side);
  all.push_back({"negated", "the right numbers with the wrong sign",
                 "Check the order of a difference or of a cross product.",
                 [](const Value& v) { return scaled(v.expected, -1); }});
  if (side == 0 && alike && size >= 2 && size <= ordinals.size()) add_vectors(all, size);
  if (vary(values)) {
    add_factor(all, values);
    add_constant(all, values);
  }
  return all;
}

// --- The verdict ---

double largest_of(const Numbers& numbers) {
  double largest = 0;
  for (double x : numbers) largest = std::max(largest, std::abs(x));
  return largest;
}

/// A tolerance for numbers up to `largest` in which an operation may round.
Tolerance loosened(Tolerance tolerance, double largest) {
  tolerance.absolute += rounding * largest;
  return tolerance;
}

/// The largest error, in tolerances, of a returned value against the result of the operation; infinite if above one.
double misfit(const Operation& operation, const Value& value, const Tolerance& tolerance) {
  const Numbers predicted = operation.apply(value);
  double worst = 0;
  const Tolerance loose = loosened(tolerance, largest_of(predicted));
  for (std::size_t k = 0; k < predicted.size(); ++k) {
    const bool lost = std::isfinite(value.expected[k]) && !std::isfinite(predicted[k]);  // no inverse, for example
    const double times = times_tolerance(value.yours[k], predicted[k], loose);
    if (lost || times > 1) return std::numeric_limits<double>::infinity();
    worst = std::max(worst, times);
  }
  return worst;
}

/// How many numbers the operation changes beyond the tolerance in which it fits, without those that its parameter was
/// derived from: a constant within rounding fits anything that is nearly right.
int evidence(const Operation& operation, const std::vector<Value>& values, const Tolerance& tolerance) {
  int all = -operation.taken;
  for (const Value& value : values) {
    const Numbers predicted = operation.apply(value);
    const Tolerance loose = loosened(tolerance, largest_of(predicted));
    int moved = 0;
    for (std::size_t k = 0; k < predicted.size(); ++k) moved += !within(predicted[k], value.expected[k], loose);
    all += std::max(0, moved - operation.taken_of_value);
  }
  return all;
}

double worst_misfit(const Operation& operation, const std::vector<Value>& values, const Tolerance& tolerance) {
  double worst = 0;
  for (const Value& value : values) worst = std::max(worst, misfit(operation, value, tolerance));
  return worst;
}

/// Whether all of these wrong values are right to a few floats' roundings, where only doubles' are allowed.
bool have_float_precision(const std::vector<Value>& wrong, const Tolerance& tolerance) {
  constexpr double one_rounding = 0x1p-24, few = 8, of_doubles = 1e-11;
  return std::ranges::all_of(wrong, [&](const Value& value) {
    const double largest = largest_of(value.expected);
    if (!(largest > 0) || within(largest * (1 + one_rounding), largest, tolerance)) return false;
    double worst = 0;
    for (std::size_t k = 0; k < value.expected.size(); ++k)
      worst = std::max(worst, std::abs(value.yours[k] - value.expected[k]));
    return worst >= of_doubles * largest && worst <= few * one_rounding * largest;
  });
}

}  // namespace

std::optional<Hypothesis> explain_values(const std::vector<Numbers>& yours, const std::vector<Numbers>& expected,
                                         const JudgedCase& c) {
  const int side = matrix_side(expected, c);
  const std::vector<Value> all = values_of(yours, expected, side);
  std::vector<Value> wrong = all;
  std::erase_if(wrong, [&](const Value& value) { return is_right(value, c.tolerance); });
  if (wrong.empty()) return std::nullopt;
  if (have_float_precision(wrong, c.tolerance))
    return Hypothesis{"float-precision",
                      fmt::format("{}{} returns numbers that are right to about seven digits, as exact as a float.",
                                  wrong.size() == all.size() ? "" : "Where it is wrong, ", c.ask.probe),
                      "The contract asks for more. Is everything a double on the way: each literal, each vector?"};

  std::vector<std::pair<double, Operation>> fitting;
  for (Operation& operation : operations_for(wrong, side)) {
    const double worst = worst_misfit(operation, wrong, c.tolerance);
    if (worst <= 1 && evidence(operation, wrong, c.tolerance) >= min_evidence)
      fitting.push_back({worst, std::move(operation)});
  }
  if (fitting.empty()) return std::nullopt;
  const double best =
      std::min_element(fitting.begin(), fitting.end(), [](auto& a, auto& b) { return a.first < b.first; })->first;
  std::erase_if(fitting, [&](const auto& fit) { return fit.first > best + as_good; });

  const Operation& first = fitting.front().second;
  std::string what = first.what;
  for (std::size_t i = 1; i < fitting.size(); ++i)
    what += (i == 1 ? ", which here is also " : " and ") + fitting[i].second.what;
  const bool everywhere = worst_misfit(first, all, c.tolerance) <= 1;
  const std::string sentence =
      fmt::format("{}{} returns {}.", everywhere ? "" : "Where it is wrong, ", c.ask.probe, what);
  return Hypothesis{first.name, sentence, first.hint};
}

}  // namespace atelier::judge
