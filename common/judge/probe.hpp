// Probes: a student's function called with given inputs, and its numbers compared.
#pragma once

#include <string>
#include <vector>

#include "case/case.hpp"
#include "judge/judged_case.hpp"

namespace atelier::judge {

/// Whether `yours` may stand for `expected`: |yours - expected| <= absolute + relative |expected|, or at most `ulp`
/// 32-bit floats lie between the two. NaN is right only where NaN is expected, an infinity only for itself.
bool within(double yours, double expected, const Tolerance& tolerance);

/// How many times its tolerance `yours` is off: 1 at the border; infinity where a number is not finite and should be,
/// or is and should not. 0 for equal. Agrees with within(): a value is within exactly where this is at most 1.
double times_tolerance(double yours, double expected, const Tolerance& tolerance);

struct ProbeMeasurement {
  bool passed = false;
  std::string
      malformed;  ///< what is wrong with the answer's shape (too few results ...); empty where it can be compared
  int inputs = 0, wrong = 0;
  int non_finite = 0;  ///< inputs answered with NaN or infinity where a finite number is expected
  int worst_input = 0, worst_component = 0;
  double worst_times = 0;  ///< times_tolerance of the worst number
  double worst_yours = 0, worst_expected = 0;
};

/// Compares input by input. `expected` holds one list an input of `c`.
ProbeMeasurement measure_probe(const std::vector<Numbers>& yours, const std::vector<Numbers>& expected,
                               const JudgedCase& c);

/// A table for the report: the inputs, yours and expected, the worst input first, at most `rows` inputs.
std::string probe_table(const std::vector<Numbers>& yours, const std::vector<Numbers>& expected, const JudgedCase& c,
                        int rows = 8);

/// "(0, 1.5, -2)"; sixteen numbers as the four rows of the matrix that they are the columns of.
std::string show_numbers(const Numbers& numbers);

}  // namespace atelier::judge
