#include "judge/compare/probe.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <numeric>

#include "base/gl_enum_name.hpp"

namespace atelier::judge {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The position of a number among all 32-bit floats in order: neighbours differ by one, both zeros are 0.
std::int64_t float_rank(double value) {
  const auto bits = std::bit_cast<std::int32_t>(float(value));
  return bits >= 0 ? bits : -std::int64_t(bits & 0x7fffffff);
}

double unsigned_zero(double x) {
  return x == 0 ? 0 : x;
}

/// The largest times_tolerance among the components of one input; infinity if the counts differ.
double worst_of(const Numbers& yours, const Numbers& expected, const Tolerance& tolerance) {
  if (yours.size() != expected.size()) return infinity;
  double worst = 0;
  for (std::size_t k = 0; k < yours.size(); ++k)
    worst = std::max(worst, times_tolerance(yours[k], expected[k], tolerance));
  return worst;
}

}  // namespace

double times_tolerance(double yours, double expected, const Tolerance& tolerance) {
  if (std::isnan(expected)) return std::isnan(yours) ? 0 : infinity;
  if (yours == expected) return 0;
  if (!std::isfinite(yours) || !std::isfinite(expected)) return infinity;
  const auto ratio = [](double off, double allowed) { return allowed > 0 ? off / allowed : infinity; };
  const double by_size =
      ratio(std::abs(yours - expected), tolerance.absolute + tolerance.relative * std::abs(expected));
  const bool floats = std::isfinite(float(yours)) && std::isfinite(float(expected));
  if (tolerance.ulp <= 0 || !floats) return by_size;
  const double by_rank = double(std::abs(float_rank(yours) - float_rank(expected))) / tolerance.ulp;
  return std::min(by_size, by_rank);
}

bool within(double yours, double expected, const Tolerance& tolerance) {
  return times_tolerance(yours, expected, tolerance) <= 1;
}

ProbeMeasurement measure_probe(const std::vector<Numbers>& yours, const std::vector<Numbers>& expected,
                               const JudgedCase& c) {
  ProbeMeasurement measured;
  measured.inputs = int(expected.size());
  if (yours.size() != expected.size()) {
    measured.malformed = fmt::format("{} results were returned for {} inputs", yours.size(), expected.size());
    measured.wrong = measured.inputs;
    return measured;
  }
  for (int i = 0; i < measured.inputs; ++i) {
    if (yours[i].size() != expected[i].size()) {
      measured.malformed =
          fmt::format("for input {} it returned {} numbers instead of {}", i, yours[i].size(), expected[i].size());
      measured.wrong = measured.inputs;
      return measured;
    }
    bool wrong = false, non_finite = false;
    for (int k = 0; k < int(expected[i].size()); ++k) {
      const double times = times_tolerance(yours[i][k], expected[i][k], c.tolerance);
      if (times <= 1 && times <= measured.worst_times) continue;
      wrong = wrong || times > 1;
      const ProbeNumber here{i, k, yours[i][k], expected[i][k]};
      if (times > 1 && !measured.first_wrong) measured.first_wrong = here;
      non_finite = non_finite || (std::isfinite(expected[i][k]) && !std::isfinite(yours[i][k]));
      if (times <= measured.worst_times) continue;
      measured.worst_times = times;
      measured.worst = here;
    }
    measured.wrong += wrong;
    measured.non_finite += non_finite;
  }
  measured.passed = measured.wrong == 0;
  return measured;
}

int matrix_side(const std::vector<Numbers>& expected) {
  const auto every = [&](auto matches) {
    return !expected.empty() && std::all_of(expected.begin(), expected.end(), matches);
  };
  const auto affine = [](const Numbers& numbers) {
    for (std::size_t k = 3; k < numbers.size(); k += 4)
      if (numbers[k] != (k % 16 == 15 ? 1 : 0)) return false;
    return !numbers.empty() && numbers.size() % 16 == 0;
  };
  if (every([](const Numbers& numbers) { return numbers.size() == 16; }) || every(affine)) return 4;
  return every([](const Numbers& numbers) { return numbers.size() == 9; }) ? 3 : 0;
}

int matrix_side(const std::vector<Numbers>& expected, const JudgedCase& c) {
  return c.numbers.empty() ? matrix_side(expected) : 0;
}

std::string place_of_number(const ProbeNumber& number, const std::vector<Numbers>& expected, const JudgedCase& c) {
  if (!c.numbers.empty()) return c.numbers[std::size_t(number.component)].name;
  const int count = int(expected[std::size_t(number.input)].size()), side = matrix_side(expected);
  if (count == 1) return "";
  if (side == 0) return fmt::format("number {} of {}", number.component + 1, count);
  const int size = side * side, column = number.component % size / side, row = number.component % side;
  const std::string matrix =
      count > size ? fmt::format(" of matrix {} of {}", number.component / size + 1, count / size) : std::string();
  return fmt::format("row {}, column {} (m[{}][{}]){}", row + 1, column + 1, column, row, matrix);
}

std::string yours_and_expected(const ProbeNumber& number, const JudgedCase& c) {
  if (!c.numbers.empty() && c.numbers[std::size_t(number.component)].is_enum)
    return fmt::format("{} instead of {}", gl_enum_name(number.yours), gl_enum_name(number.expected));
  for (int digits = 7; digits < 17; ++digits) {
    const std::string yours = fmt::format("{:.{}g}", unsigned_zero(number.yours), digits),
                      expected = fmt::format("{:.{}g}", unsigned_zero(number.expected), digits);
    if (yours != expected) return yours + " instead of " + expected;
  }
  return fmt::format("{:.17g} instead of {:.17g}", number.yours, number.expected);
}

std::string show_numbers(const Numbers& numbers) {
  if (numbers.size() == 1) return fmt::format("{:.7g}", unsigned_zero(numbers[0]));
  Numbers shown = numbers;
  for (double& x : shown) x = unsigned_zero(x);
  return fmt::format("({:.7g})", fmt::join(shown, ", "));
}

std::string show_matrices(const Numbers& columns, int side, double noise) {
  const std::size_t rows = std::size_t(side), size = rows * rows;
  std::string text;
  for (std::size_t first = 0; first + size <= columns.size(); first += size)
    for (std::size_t row = 0; row < rows; ++row) {
      text += text.empty() ? "[" : row == 0 ? "\n\n[" : "\n[";
      for (std::size_t column = 0; column < rows; ++column) {
        const double x = columns[first + column * rows + row];
        text += fmt::format("{:>13.7g} ", std::abs(x) < noise ? 0 : unsigned_zero(x));
      }
      text += "]";
    }
  return text;
}

namespace {

/// A line for each wrong number of a result whose numbers have names.
std::string wrong_numbers(int input, const Numbers& yours, const Numbers& expected, const JudgedCase& c) {
  std::string text;
  for (std::size_t k = 0; k < std::min({yours.size(), expected.size(), c.numbers.size()}); ++k)
    if (!within(yours[k], expected[k], c.tolerance))
      text +=
          fmt::format("  {}: {}\n", c.numbers[k].name, yours_and_expected({input, int(k), yours[k], expected[k]}, c));
  return text;
}

}  // namespace

std::string probe_table(const std::vector<Numbers>& yours, const std::vector<Numbers>& expected, const JudgedCase& c,
                        int rows) {
  const std::size_t inputs = std::min({yours.size(), expected.size(), c.ask.inputs.size()});
  std::vector<double> times(inputs);
  for (std::size_t i = 0; i < inputs; ++i) times[i] = worst_of(yours[i], expected[i], c.tolerance);
  std::vector<std::size_t> order(inputs);
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return times[a] > times[b]; });

  // A list goes on the label's line, a matrix below it.
  const auto line = [](const std::string& label, const Numbers& numbers, int side, double noise) {
    return fmt::format("  {:<9}{}{}\n", label, side > 0 ? "\n" : " ",
                       side > 0 ? show_matrices(numbers, side, noise) : show_numbers(numbers));
  };
  const int side = matrix_side(expected, c);
  const double noise = c.tolerance.absolute;
  std::string text;
  for (std::size_t i : order) {
    if (rows-- == 0) {
      text += fmt::format("... and {} more inputs\n",
                          inputs - std::size_t(std::find(order.begin(), order.end(), i) - order.begin()));
      break;
    }
    text += fmt::format("input {}: {}\n", i,
                        times[i] == 0          ? "equal"
                        : times[i] <= 1        ? fmt::format("right, at {:.2g} of the tolerance", times[i])
                        : std::isinf(times[i]) ? std::string("wrong")
                                               : fmt::format("wrong, {:.3g} times the tolerance", times[i]));
    if (!c.numbers.empty()) {
      text += wrong_numbers(int(i), yours[i], expected[i], c);
    } else {
      text += line("expected", expected[i], side, noise);
      if (times[i] > 0) text += line("yours", yours[i], side, noise);
    }
    for (const auto& [name, numbers] : c.ask.inputs[i].values) text += line(name, numbers, matrix_side({numbers}), 0);
  }
  return text;
}

}  // namespace atelier::judge
