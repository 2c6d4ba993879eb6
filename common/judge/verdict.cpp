#include "judge/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/error.hpp"
#include "image/flip.hpp"
#include "judge/credit.hpp"
#include "judge/gate.hpp"
#include "judge/hypotheses.hpp"
#include "judge/measure.hpp"
#include "judge/naming.hpp"
#include "judge/probe.hpp"
#include "judge/sentences.hpp"
#include "judge/value_hypotheses.hpp"

namespace atelier::judge {
namespace {

Status status_of(Answer::Ended ended) {
  switch (ended) {
    case Answer::Ended::normally:
      return Status::failed;
    case Answer::Ended::missing:
      return Status::missing;
    case Answer::Ended::crashed:
      return Status::crashed;
    case Answer::Ended::timeout:
      return Status::timeout;
    case Answer::Ended::build_failed:
      return Status::build_failed;
  }
  return Status::missing;
}

std::string default_reason(Status status) {
  switch (status) {
    case Status::crashed:
      return "The program crashed in this case.";
    case Status::timeout:
      return "The program did not finish this case in time.";
    case Status::build_failed:
      return "The files did not compile.";
    default:
      return "The program wrote no answer to this case.";
  }
}

/// What to try where there is nothing to compare: the case's own hint is about an answer that came.
std::string hint_without_answer(Status status, const std::string& hint_of_case) {
  switch (status) {
    case Status::build_failed:
      return "Mend what the compiler names first: nothing that needs this file can be judged before.";
    case Status::crashed:
      return "Look for an index out of range, a null pointer, a recursion without end, or something thrown that "
             "nothing "
             "catches; a debugger names the line.";
    case Status::timeout:
      return "Look for a loop that never ends, or that makes its work longer while it runs.";
    default:
      return hint_of_case;
  }
}

CaseResult blank(const JudgedCase& c, const Answer& answer, const StepReferences& references) {
  CaseResult result;
  result.name = c.ask.name;
  result.title = c.title;
  result.status = status_of(answer.ended);
  result.max_score = c.points;
  result.asked = c.asked;
  result.hint = c.hint;
  result.command = fmt::format("./atelier check {} --case {}", references.step(), c.ask.name);
  result.output = answer.output;
  return result;
}

void pass(CaseResult& result) {
  result.status = Status::passed;
  result.score = result.max_score;
  result.hint.clear();
}

void give(CaseResult& result, const Credit& credit) {
  result.score = credit.fraction * result.max_score;
  result.credit = result.score > 0 ? credit.explanation : "";
}

void name_mistake(CaseResult& result, const std::string& name, const StepReferences& references) {
  result.mistake = name;
  const Mistake* known = references.mistake(name);
  if (!known) return;
  result.mistake_sentence = known->sentence;
  if (!known->hint.empty()) result.hint = known->hint;
}

/// Puts a hypothesis in front of what was seen.
void say_hypothesis(CaseResult& result, const Hypothesis& whole) {
  result.hypothesis = whole.name;
  result.reason = whole.sentence + " " + result.reason;
  result.hint = whole.hint;
}

// --- Pictures ---

/// An answer with the reference that it comes nearest to.
struct Match {
  const Image* reference_raw = nullptr;
  Image yours, reference;  // in compared form
  Measurement measured;
};

/// Passed before failed, then by the failing pixels. The first of equals, so that the order of the case file decides.
bool better(const Measurement& a, const Measurement& b) {
  if (a.passed != b.passed) return a.passed;
  return a.difference.over < b.difference.over;
}

Match best_match(const JudgedCase& c, const Image& yours_raw, const std::vector<Image>& references) {
  Match best;
  best.yours = compared_form(yours_raw, c);
  for (const Image& raw : references) {
    Image reference = compared_form(raw, c);
    Measurement measured = measure(best.yours, reference, c);
    if (best.reference_raw && !better(measured, best.measured)) continue;
    best.reference_raw = &raw;
    best.reference = std::move(reference);
    best.measured = std::move(measured);
    if (best.measured.passed) break;
  }
  return best;
}

/// Both data pictures mapped by the reference's range to 0..1, where it does not lie there already: what can be looked
/// at.
void make_visible(Image& yours, Image& reference) {
  float low = std::numeric_limits<float>::max(), high = std::numeric_limits<float>::lowest();
  for (const Rgba& p : reference.pixels()) {
    low = std::min({low, p.r, p.g, p.b});
    high = std::max({high, p.r, p.g, p.b});
  }
  if ((low >= 0 && high <= 1) || !(high > low)) return;
  for (Image* image : {&yours, &reference})
    for (Rgba& p : image->pixels())
      p = {(p.r - low) / (high - low), (p.g - low) / (high - low), (p.b - low) / (high - low), 1};
}

void keep_evidence(CaseResult& result, Match& match, const JudgedCase& c) {
  Evidence evidence;
  evidence.colours = is_colour(c.unit);
  evidence.over = to_image(match.measured.difference.mask);
  evidence.yours = std::move(match.yours);
  evidence.reference = std::move(match.reference);
  if (c.unit == Unit::number) make_visible(evidence.yours, evidence.reference);
  result.evidence = std::move(evidence);
}

void keep_figures(CaseResult& result, const Measurement& measured) {
  result.figures["over"] = measured.difference.over;
  result.figures["share"] = measured.difference.share;
  result.figures["blob"] = measured.difference.blob;
  result.figures["largest"] = measured.difference.worst_distance;
  result.figures["shift"] = measured.shift.length();
}

/// Names the mistake of the atlas that the picture looks like, and keeps that mistake's picture for the report.
void name_picture(CaseResult& result, const Match& match, const JudgedCase& c, const StepReferences& references,
                  std::optional<Image>& mistake_picture) {
  const CaseAtlas& atlas = references.atlas(c);
  if (atlas.pictures.empty()) return;
  const auto found =
      recognised(rank_mistakes(make_atlas_picture(match.yours, match.reference, c.unit),
                               make_atlas_picture(match.reference, match.reference, c.unit), atlas.pictures));
  if (!found) return;
  name_mistake(result, found->mistake, references);
  result.figures["nearness"] = found->distance / found->reference;
  for (const AtlasPicture& entry : atlas.pictures)
    if (entry.mistake == found->mistake && entry.same_view) mistake_picture = entry.picture;
}

void explain_picture(CaseResult& result, const Match& match, const JudgedCase& c, const Image& yours_raw,
                     const StepReferences& references, std::optional<Image>& mistake_picture) {
  const Measurement& measured = match.measured;
  result.reason = describe_failure(measured, match.yours, match.reference, c);
  const auto whole = explain_whole_picture(
      {yours_raw, *match.reference_raw, match.yours, match.reference, c, measured.difference.mask});
  if (whole) say_hypothesis(result, *whole);
  name_picture(result, match, c, references, mistake_picture);

  Shortfall shortfall;
  shortfall.share = measured.share;
  shortfall.weighted = !c.regions.empty();
  shortfall.budget_share = double(effective_budget(c, measured.pixels)) / measured.pixels;
  shortfall.skeleton_share = references.of(c).skeleton_share;
  shortfall.blob = measured.difference.blob > 0;
  shortfall.whole_picture = whole.has_value() || measured.shifted;
  give(result, partial_credit(shortfall));
}

/// A picture that did not come through gate 0: what is there is shown, and its mistake named where many look like it.
void stop_at_gate(CaseResult& result, const GateFailure& stopped, const JudgedCase& c, const Image& yours,
                  const StepReferences& references, KeepEvidence keep) {
  result.reason = stopped.sentence;
  result.hint = stopped.hint;
  const Image& right = references.of(c).pictures.front();
  if (stopped.kind == GateFailure::Kind::size) return;
  Match match;
  match.reference_raw = &right;
  match.yours = compared_form(with_non_finite_marked(yours), c);
  match.reference = compared_form(right, c);
  match.measured.pixels = int(right.pixels().size());
  constexpr double no_finite_difference = 1e30;  // so that only what is not finite is over it
  match.measured.difference = compare_strict(yours, right, Measure::number, no_finite_difference);
  std::optional<Image> mistake_picture;
  if (stopped.kind == GateFailure::Kind::single_colour) {
    match.measured = measure(match.yours, match.reference, c);
    keep_figures(result, match.measured);
    name_picture(result, match, c, references, mistake_picture);
  } else {
    result.figures["non_finite"] = stopped.count;
  }
  if (keep == KeepEvidence::never) return;
  keep_evidence(result, match, c);
  result.evidence->mistake = std::move(mistake_picture);
}

CaseResult judge_picture(CaseResult result, const JudgedCase& c, const Answer& answer, const StepReferences& references,
                         KeepEvidence keep) {
  const std::vector<Image>& right = references.of(c).pictures;
  if (!answer.pixels) {
    result.status = Status::missing;
    result.reason = answer.error.empty() ? default_reason(Status::missing) : answer.error;
    return result;
  }
  const Image& yours = *answer.pixels;
  if (const auto stopped = stopped_at_gate(yours, right, c)) {
    stop_at_gate(result, *stopped, c, yours, references, keep);
    return result;
  }
  Match match = best_match(c, yours, right);
  keep_figures(result, match.measured);
  std::optional<Image> mistake_picture;
  if (match.measured.passed) {
    pass(result);
    result.reason = describe_pass(match.measured, c);
  } else {
    result.worst = worst_pixel(match.measured, match.yours, match.reference, c.unit);
    explain_picture(result, match, c, yours, references, mistake_picture);
  }
  const bool wanted = keep == KeepEvidence::always || (keep == KeepEvidence::failures && !match.measured.passed);
  if (!wanted) return result;
  keep_evidence(result, match, c);
  result.evidence->mistake = std::move(mistake_picture);
  return result;
}

// --- Choices ---

CaseResult judge_choice(CaseResult result, const JudgedCase& c, const Answer& answer, const StepReferences& references,
                        KeepEvidence keep) {
  const std::vector<Image>& truth = references.of(c).pictures;
  if (!answer.pixels) {
    result.status = Status::missing;
    result.reason = answer.error.empty() ? default_reason(Status::missing) : answer.error;
    return result;
  }
  if (const auto stopped = stopped_at_gate(*answer.pixels, truth, c)) {
    stop_at_gate(result, *stopped, c, *answer.pixels, references, keep);
    return result;
  }
  for (const auto& [name, most] : c.choice->at_most)
    if (!answer.counts.contains(name)) {
      result.status = Status::missing;
      result.reason = fmt::format("The program did not say what the picture costs: '{}' is missing.", name);
      return result;
    }
  const ChoiceMeasurement measured =
      measure_choice(*answer.pixels, truth.front(), encoding_of(c.unit), answer.counts, *c.choice);
  result.figures["error"] = measured.error;
  for (const auto& [name, most] : c.choice->at_most) result.figures[name] = double(answer.counts.at(name));
  result.reason = describe_choice(measured, answer.counts, *c.choice);
  if (measured.passed())
    pass(result);
  else
    give(result,
         {measured.credit, "By the logarithm of the error, between what earns all points and what earns none."});
  if (keep == KeepEvidence::always || (keep == KeepEvidence::failures && !measured.passed())) {
    Match match = best_match(c, *answer.pixels, truth);
    keep_evidence(result, match, c);
  }
  return result;
}

// --- Probes ---

/// "at input 2: row 1, column 4 (m[3][0]) is 0 in place of 5"
std::string number_words(const ProbeNumber& number, const std::vector<Numbers>& expected) {
  const auto count = int(expected[std::size_t(number.input)].size());
  const std::string place = place_of_number(number.component, count, matrix_side(expected));
  return fmt::format("at input {}: {} is {} in place of {}", number.input, place.empty() ? "the result" : place,
                     show_numbers({number.yours}), show_numbers({number.expected}));
}

std::string describe_probe(const ProbeMeasurement& measured, const std::vector<Numbers>& expected,
                           const JudgedCase& c) {
  const std::string& name = c.ask.probe;
  if (!measured.malformed.empty()) return fmt::format("{}: {}.", name, measured.malformed);
  const std::string inputs = measured.inputs == 1 ? "the one input" : fmt::format("all {} inputs", measured.inputs);
  if (measured.passed)
    return measured.worst_times == 0 ? fmt::format("{} is right for {}.", name, inputs)
                                     : fmt::format("{} is right for {}; the worst is at {:.2g} of the tolerance.", name,
                                                   inputs, measured.worst_times);
  const std::string wrong =
      measured.wrong == measured.inputs ? inputs : fmt::format("{} of {} inputs", measured.wrong, measured.inputs);
  const ProbeNumber &first = measured.first_wrong.value(), &worst = measured.worst;
  std::string text = fmt::format("{} is wrong for {}. First {}", name, wrong, number_words(first, expected));
  if (first.input != worst.input || first.component != worst.component)
    text += fmt::format("; farthest off {}", number_words(worst, expected));
  text += '.';
  if (measured.non_finite > 0) text += fmt::format(" For {} of them NaN or infinity comes back.", measured.non_finite);
  return text;
}

CaseResult judge_probe(CaseResult result, const JudgedCase& c, const Answer& answer, const StepReferences& references) {
  const CaseReferences& right = references.of(c);
  if (!answer.values) {
    result.status = Status::missing;
    result.reason = answer.error.empty() ? default_reason(Status::missing) : answer.error;
    return result;
  }
  const ProbeMeasurement measured = measure_probe(*answer.values, right.values, c);
  result.figures["inputs"] = measured.inputs;
  result.figures["wrong"] = measured.wrong;
  if (std::isfinite(measured.worst_times)) result.figures["largest"] = measured.worst_times;
  result.table = probe_table(*answer.values, right.values, c);
  result.reason = describe_probe(measured, right.values, c);
  if (measured.passed) {
    pass(result);
    return result;
  }
  if (measured.malformed.empty())
    if (const auto whole = explain_values(*answer.values, right.values, c)) say_hypothesis(result, *whole);
  if (const auto name = recognise_values(*answer.values, references.atlas(c).values, c))
    name_mistake(result, *name, references);
  if (measured.malformed.empty())
    give(result, partial_probe_credit(measured.wrong, measured.inputs, right.skeleton_share));
  return result;
}

}  // namespace

CaseResult judge_case(const JudgedCase& c, const Answer& answer, const StepReferences& references, KeepEvidence keep) {
  references.of(c);  // a broken reference is our failure, and is said whatever the answer was
  CaseResult result = blank(c, answer, references);
  if (answer.ended != Answer::Ended::normally) {
    result.reason = answer.error.empty() ? default_reason(result.status) : answer.error;
    result.hint = hint_without_answer(result.status, c.hint);
    return result;
  }
  if (c.choice) return judge_choice(std::move(result), c, answer, references, keep);
  return c.profile == Profile::values ? judge_probe(std::move(result), c, answer, references)
                                      : judge_picture(std::move(result), c, answer, references, keep);
}

void draw_flip(CaseResult& result) {
  if (!result.evidence || !result.evidence->colours || !result.evidence->flip.empty()) return;
  Evidence& evidence = *result.evidence;
  FlipOptions options;
  options.encoding = Encoding::srgb;
  Flip error = flip(evidence.reference, evidence.yours, options);
  evidence.flip = std::move(error.map);
  result.figures["flip_mean"] = error.mean;
}

}  // namespace atelier::judge
