// Probes: a student's function called with given inputs, and its numbers compared.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "judge/compare/judged_case.hpp"

namespace atelier::judge {

/// Whether `yours` may stand for `expected`: |yours - expected| <= absolute + relative |expected|, or at most `ulp`
/// 32-bit floats lie between the two. NaN is right only where NaN is expected, an infinity only for itself.
bool within(double yours, double expected, const Tolerance& tolerance);

/// How many times its tolerance `yours` is off: 1 at the border; infinity where a number is not finite and should be,
/// or is and should not. 0 for equal. Agrees with within(): a value is within exactly where this is at most 1.
double times_tolerance(double yours, double expected, const Tolerance& tolerance);

/// One number of a probe's answer.
struct ProbeNumber {
  int input = 0, component = 0;
  double yours = 0, expected = 0;
};

struct ProbeMeasurement {
  bool passed = false;
  std::string
      malformed;  ///< what is wrong with the answer's shape (too few results ...); empty where it can be compared
  int inputs = 0, wrong = 0;
  int non_finite = 0;  ///< inputs answered with NaN or infinity where a finite number is expected
  std::optional<ProbeNumber> first_wrong;
  ProbeNumber worst;
  double worst_times = 0;  ///< times_tolerance of the worst number
};

/// Compares input by input. `expected` holds one list an input of `c`.
ProbeMeasurement measure_probe(const std::vector<Numbers>& yours, const std::vector<Numbers>& expected,
                               const JudgedCase& c);

/// 4 or 3 where the right answer to every input is a matrix of so many rows, or for 4 a list of them: 16 or 9 numbers;
/// or several times 16, of which each 16 have the fourth row 0 0 0 1. 0 for other numbers.
int matrix_side(const std::vector<Numbers>& expected);

/// "number 2 of 3"; in a matrix of `side` rows "row 1, column 4 (m[3][0])", as one says it and as GLSL and glm count.
/// Empty for a single number.
std::string place_of_number(int component, int count, int side);

/// A table for the report: the inputs, yours and expected, the worst input first, at most `rows` inputs.
std::string probe_table(const std::vector<Numbers>& yours, const std::vector<Numbers>& expected, const JudgedCase& c,
                        int rows = 8);

/// "(0, 1.5, -2)"; no zero has a sign.
std::string show_numbers(const Numbers& numbers);

/// The rows of a matrix of `side` rows, or of several, each the columns one after another. A number below `noise` in
/// size is shown as 0.
std::string show_matrices(const Numbers& columns, int side, double noise = 0);

}  // namespace atelier::judge
