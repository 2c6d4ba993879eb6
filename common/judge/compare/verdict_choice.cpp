#include <fmt/format.h>

#include "judge/compare/verdict_picture.hpp"
#include "judge/explain/sentences.hpp"

namespace atelier::judge {

CaseResult judge_choice(CaseResult result, const JudgedCase& c, const Answer& answer, const StepReferences& references,
                        KeepEvidence keep) {
  const std::vector<Image>& truth = references.of(c).pictures;
  if (!is_comparable(result, c, answer, references, keep)) return result;
  for (const auto& [name, most] : c.choice->at_most)
    if (!answer.counts.contains(name)) {
      result.status = Status::missing;
      result.reason = fmt::format("The program did not report the picture's cost: '{}' is missing.", name);
      return result;
    }
  const ChoiceMeasurement measured =
      measure_choice(*answer.pixels, truth.front(), encoding_of(c.unit), answer.counts, *c.choice);
  result.figures["error"] = measured.error;
  for (const auto& [name, most] : c.choice->at_most) result.figures[name] = double(answer.counts.at(name));
  result.reason = describe_choice(measured, answer.counts, *c.choice);
  for (const auto& [mistake, known] : references.atlas(c).values.mistakes)
    if (!measured.passed() && exceeded(measured, answer.counts, *c.choice) == known.front())
      result.could_be.push_back(mistake);
  if (measured.passed())
    give_full_credit(result);
  else
    give_partial_credit(result, {measured.credit,
                                 "Logarithmic in the error, between the error for all points and the error for none."});
  if (keep == KeepEvidence::always || (keep == KeepEvidence::failures && !measured.passed())) {
    Match match = best_match(c, *answer.pixels, truth);
    keep_evidence(result, match, c);
  }
  return result;
}

}  // namespace atelier::judge
