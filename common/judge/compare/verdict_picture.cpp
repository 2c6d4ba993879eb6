#include "judge/compare/verdict_picture.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "judge/compare/gate.hpp"
#include "judge/explain/naming.hpp"
#include "judge/explain/sentences.hpp"

namespace atelier::judge {
namespace {

/// Passed is better than failed; then fewer failing pixels. Not better if equal, so that the first reference is kept.
bool better(const Measurement& a, const Measurement& b) {
  if (a.passed != b.passed) return a.passed;
  return a.difference.over < b.difference.over;
}

/// Maps both data pictures from the reference's range to 0..1, unless it is within 0..1, so that they can be shown.
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

void keep_figures(CaseResult& result, const Measurement& measured) {
  result.figures["over"] = measured.difference.over;
  result.figures["share"] = measured.difference.share;
  result.figures["blob"] = measured.difference.blob;
  result.figures["largest"] = measured.difference.worst_distance;
  result.figures["shift"] = measured.shift.length();
}

/// Finds the mistake of the atlas that the picture looks like, and its picture for the report.
void recognise_picture(CaseResult& result, const Match& match, const JudgedCase& c, const StepReferences& references,
                       std::optional<Image>& mistake_picture) {
  const CaseAtlas& atlas = references.atlas(c);
  if (atlas.pictures.empty()) return;
  const auto found =
      recognise(rank_mistakes(make_atlas_picture(match.yours, match.reference, c.unit),
                              make_atlas_picture(match.reference, match.reference, c.unit), atlas.pictures));
  if (!found) return;
  result.could_be = {found->mistake};
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
  if (whole) add_hypothesis(result, *whole);
  recognise_picture(result, match, c, references, mistake_picture);

  PictureFailure failure;
  failure.failing_fraction = measured.failing_fraction;
  failure.weighted = !c.regions.empty();
  failure.budget_fraction = double(effective_budget(c, measured.pixels)) / measured.pixels;
  failure.skeleton_fraction = references.of(c).skeleton_fraction;
  failure.blob = measured.difference.blob > 0;
  failure.whole_picture = whole.has_value() || measured.shifted;
  give_partial_credit(result, partial_credit(failure));
}

}  // namespace

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

void keep_evidence(CaseResult& result, Match& match, const JudgedCase& c) {
  Evidence evidence;
  evidence.colours = is_colour(c.unit);
  evidence.over = to_image(match.measured.difference.mask);
  evidence.yours = std::move(match.yours);
  evidence.reference = std::move(match.reference);
  if (c.unit == Unit::number) make_visible(evidence.yours, evidence.reference);
  result.evidence = std::move(evidence);
}

namespace {

/// Completes the result of a picture that failed at the gate. Recognises the mistake of a single-colour picture.
void report_gate_failure(CaseResult& result, const GateFailure& stopped, const JudgedCase& c, const Image& yours,
                         const StepReferences& references, KeepEvidence keep) {
  result.reason = stopped.sentence;
  result.hint = stopped.hint;
  const Image& right = references.of(c).pictures.front();
  if (stopped.kind == GateFailure::Kind::size) return;
  Match match;
  match.reference_raw = &right;
  match.yours = compared_form(mark_non_finite(yours), c);
  match.reference = compared_form(right, c);
  match.measured.pixels = int(right.pixels().size());
  constexpr double huge_delta = 1e30;  // only values that are not finite exceed it
  match.measured.difference = compare_strict(yours, right, Measure::number, huge_delta);
  std::optional<Image> mistake_picture;
  if (stopped.kind == GateFailure::Kind::single_colour) {
    match.measured = measure(match.yours, match.reference, c);
    keep_figures(result, match.measured);
    recognise_picture(result, match, c, references, mistake_picture);
  } else {
    result.figures["non_finite"] = stopped.count;
  }
  if (keep == KeepEvidence::never) return;
  keep_evidence(result, match, c);
  result.evidence->mistake = std::move(mistake_picture);
}

}  // namespace

bool is_comparable(CaseResult& result, const JudgedCase& c, const Answer& answer, const StepReferences& references,
                   KeepEvidence keep) {
  if (!answer.pixels) {
    set_missing(result, answer);
    return false;
  }
  const auto stopped = find_gate_failure(*answer.pixels, references.of(c).pictures, c);
  if (stopped) report_gate_failure(result, *stopped, c, *answer.pixels, references, keep);
  return !stopped;
}

CaseResult judge_picture(CaseResult result, const JudgedCase& c, const Answer& answer, const StepReferences& references,
                         KeepEvidence keep) {
  if (!is_comparable(result, c, answer, references, keep)) return result;
  const Image& yours = *answer.pixels;
  Match match = best_match(c, yours, references.of(c).pictures);
  keep_figures(result, match.measured);
  std::optional<Image> mistake_picture;
  if (match.measured.passed) {
    give_full_credit(result);
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

}  // namespace atelier::judge
