#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "judge/compare/probe.hpp"
#include "judge/compare/verdict_parts.hpp"
#include "judge/explain/naming.hpp"
#include "judge/explain/sentences.hpp"
#include "judge/explain/value_hypotheses.hpp"

namespace atelier::judge {
namespace {

/// "at input 2: row 1, column 4 (m[3][0]) is 0 instead of 5"
std::string number_words(const ProbeNumber& number, const std::vector<Numbers>& expected, const JudgedCase& c) {
  const std::string place = place_of_number(number, expected, c);
  return fmt::format("at input {}: {} is {}", number.input, place.empty() ? "the result" : place,
                     yours_and_expected(number, c));
}

std::string describe_probe(const ProbeMeasurement& measured, const std::vector<Numbers>& expected,
                           const JudgedCase& c) {
  const std::string& name = c.ask.probe;
  if (!measured.malformed.empty()) return fmt::format("{}: {}.", name, measured.malformed);
  const std::string inputs = measured.inputs == 1 ? "the only input" : fmt::format("all {} inputs", measured.inputs);
  if (measured.passed)
    return measured.worst_times == 0 ? fmt::format("{} is right for {}.", name, inputs)
                                     : fmt::format("{} is right for {}; the worst is at {:.2g} of the tolerance.", name,
                                                   inputs, measured.worst_times);
  const std::string wrong =
      measured.wrong == measured.inputs ? inputs : fmt::format("{} of {} inputs", measured.wrong, measured.inputs);
  const ProbeNumber &first = measured.first_wrong.value(), &worst = measured.worst;
  std::string text = fmt::format("{} is wrong for {}. First error {}", name, wrong, number_words(first, expected, c));
  if (first.input != worst.input || first.component != worst.component)
    text += fmt::format("; worst error {}", number_words(worst, expected, c));
  text += '.';
  if (measured.non_finite > 0) text += fmt::format(" For {} of them it returns NaN or infinity.", measured.non_finite);

  return text;
}

}  // namespace

CaseResult judge_probe(CaseResult result, const JudgedCase& c, const Answer& answer, const StepReferences& references) {
  const CaseReferences& right = references.of(c);
  if (!answer.values) {
    set_missing(result, answer);
    return result;
  }
  const ProbeMeasurement measured = measure_probe(*answer.values, right.values, c);
  result.figures["inputs"] = measured.inputs;
  result.figures["wrong"] = measured.wrong;
  if (std::isfinite(measured.worst_times)) result.figures["largest"] = measured.worst_times;
  result.table = probe_table(*answer.values, right.values, c);
  result.reason = describe_probe(measured, right.values, c);
  if (measured.passed) {
    give_full_credit(result);
    return result;
  }
  const WrongValues& known = references.atlas(c).values;
  result.unwritten = std::any_of(known.unwritten.begin(), known.unwritten.end(),
                                 [&](const auto& values) { return measure_probe(*answer.values, values, c).passed; });
  if (measured.malformed.empty() && !result.unwritten)
    if (const auto whole = explain_values(*answer.values, right.values, c)) add_hypothesis(result, *whole);
  result.could_be = recognise_values(*answer.values, known.mistakes, c);
  if (measured.malformed.empty())
    give_partial_credit(result, partial_probe_credit(measured.wrong, measured.inputs, right.skeleton_fraction));
  return result;
}

}  // namespace atelier::judge
