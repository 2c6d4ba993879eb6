// Probes: compares the results of a student's function for given inputs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "judge/compare/judged_case.hpp"

namespace atelier::judge {

/// Whether `yours` is within the tolerance: |yours - expected| <= absolute + relative |expected|, or the two are at
/// most `ulp` 32-bit floats apart. NaN matches only NaN, an infinity only itself.
bool within(double yours, double expected, const Tolerance& tolerance);

/// The error of `yours` as a multiple of the tolerance: 0 if equal, infinity if only one of the two is finite. within()
/// is true exactly if this is at most 1.
double times_tolerance(double yours, double expected, const Tolerance& tolerance);

/// One number of a probe's answer.
struct ProbeNumber {
  int input = 0, component = 0;
  double yours = 0, expected = 0;
};

struct ProbeMeasurement {
  bool passed = false;
  std::string malformed;  ///< the problem with the answer's shape (too few results ...); empty if it can be compared
  int inputs = 0, wrong = 0;
  int non_finite = 0;  ///< inputs with NaN or infinity where a finite number is expected
  std::optional<ProbeNumber> first_wrong;
  ProbeNumber worst;
  double worst_times = 0;  ///< times_tolerance of the worst number
};

/// Compares input by input. `expected` has one list per input of `c`.
ProbeMeasurement measure_probe(const std::vector<Numbers>& yours, const std::vector<Numbers>& expected,
                               const JudgedCase& c);

/// 4 if every expected result is a 4x4 matrix (16 numbers) or a list of affine ones (a multiple of 16 numbers, each
/// fourth row 0 0 0 1), 3 if every one is a 3x3 matrix (9 numbers), otherwise 0.
int matrix_side(const std::vector<Numbers>& expected);
/// The same for the results of a case: 0 if its numbers have names.
int matrix_side(const std::vector<Numbers>& expected, const JudgedCase& c);

/// "eye.y" if the case names its numbers; otherwise "number 2 of 3", or in a matrix of `side` rows "row 1, column 4
/// (m[3][0])", counted from 1 in words and as in GLSL and glm in brackets. Empty for a single number.
std::string place_of_number(const ProbeNumber& number, const std::vector<Numbers>& expected, const JudgedCase& c);

/// "0 instead of 5": with as many digits as tell the two apart, at least 7; enums by their names.
std::string yours_and_expected(const ProbeNumber& number, const JudgedCase& c);

/// A table for the report: inputs, expected and your results, the worst input first, at most `rows` inputs. Of named
/// numbers only those that are wrong.
std::string probe_table(const std::vector<Numbers>& yours, const std::vector<Numbers>& expected, const JudgedCase& c,
                        int rows = 8);

/// "(0, 1.5, -2)"; zero is shown without a sign.
std::string show_numbers(const Numbers& numbers);

/// The rows of one or several matrices of `side` rows, given as their columns in order. An absolute value below `noise`
/// is shown as 0.
std::string show_matrices(const Numbers& columns, int side, double noise = 0);

}  // namespace atelier::judge
