// Other correct pictures must pass; wrong ones must fail, however small the wrong fraction of the picture.
#include "catch.hpp"
#include "judge/compare/measure.hpp"
#include "judge/compare/verdict.hpp"
#include "synthetic.hpp"

namespace atelier::judge::test {
namespace {

using atelier::test::mentions;

/// The solution's picture as the one reference of a case.
StepReferences reference_of(Image picture) {
  StepReferences references("02-blinn-phong");
  CaseReferences right;
  right.pictures.push_back(std::move(picture));
  references.add("sphere", std::move(right));
  return references;
}

template <class Change>
Image drawn_with(Change change) {
  Drawing drawing;
  change(drawing);
  return draw(drawing);
}

struct Drawn {
  const char* name;
  Image picture;
};

const Image& right_picture() {
  static const Image picture = draw({});
  return picture;
}

// Three times the worst correct variant, as the rule for budgets has it: the jitter below puts 5 pixels over delta.
constexpr int budget = 15;

std::vector<Drawn> right_rows() {
  return {
      {"the very picture", right_picture()},
      {"noise of 1/255", with_noise(right_picture(), 1)},
      {"samples moved by 1/256 pixel", drawn_with([](Drawing& d) { d.offset_x = d.offset_y = 1 / 256.0; })},
      {"the same formulas in another order", drawn_with([](Drawing& d) { d.reformulated = true; })},
  };
}

std::vector<Drawn> wrong_rows() {
  return {
      {"exponent 36 for 32", drawn_with([](Drawing& d) { d.exponent = 36; })},
      {"half a texel beside", drawn_with([](Drawing& d) { d.texel_offset = 0.5; })},
      {"nearest for linear filtering", drawn_with([](Drawing& d) { d.nearest = true; })},
      {"green of the normal map flipped", drawn_with([](Drawing& d) { d.green_flipped = true; })},
      {"R.V for N.H", drawn_with([](Drawing& d) { d.mirrored_for_half = true; })},
      {"no ambient light", drawn_with([](Drawing& d) { d.no_ambient = true; })},
      {"a hole in the shadow", drawn_with([](Drawing& d) { d.hole_in_shadow = true; })},
      {"a line of 65 pixels", with_line(right_picture(), 65)},
      {"half a pixel beside", drawn_with([](Drawing& d) { d.offset_x = 0.5; })},
      {"a tenth of a pixel beside", drawn_with([](Drawing& d) { d.offset_y = 0.1; })},
  };
}

TEST_CASE("strict: other correct pictures pass") {
  const JudgedCase c = picture_case(Profile::strict, Unit::colour, 3, budget);
  const StepReferences references = reference_of(right_picture());
  for (const Drawn& row : right_rows()) {
    INFO(row.name);
    const CaseResult result = judge_case(c, answer_of(row.picture), references);
    CHECK(result.status == Status::passed);
    CHECK(result.score == 10);
    CHECK(result.credit.empty());
    CHECK(result.hint.empty());
    CHECK_FALSE(result.evidence.has_value());
  }
}

TEST_CASE("strict: wrong pictures fail, however small the wrong fraction") {
  const JudgedCase c = picture_case(Profile::strict, Unit::colour, 3, budget);
  const StepReferences references = reference_of(right_picture());
  for (const Drawn& row : wrong_rows()) {
    INFO(row.name);
    const CaseResult result = judge_case(c, answer_of(row.picture), references);
    CHECK(result.status == Status::failed);
    CHECK(result.score < 10);
    CHECK_FALSE(result.reason.empty());
    REQUIRE(result.worst.has_value());
    REQUIRE(result.evidence.has_value());
    CHECK(result.evidence->over.at(result.worst->x, result.worst->y).r == 1);
    CHECK(result.evidence->flip.empty());  // drawn with the report, not before
  }
}

TEST_CASE("strict: each rule, on a picture that breaks no other") {
  const Image flat = changed(right_picture(), [](const Rgba&) { return Rgba{0.2f, 0.2f, 0.2f, 1}; });
  Image reference = flat;
  reference.at(0, 0) = {0.9f, 0.1f, 0.1f, 1};  // no single colour, so that gate 0 has no say
  const StepReferences references = reference_of(reference);
  const auto with_spots = [&](int count, int stride) {
    Image picture = reference;
    for (int i = 0; i < count; ++i) picture.at(20 + stride * (i % 3), 20 + stride * (i / 3)) = {0.8f, 0.8f, 0.8f, 1};
    return picture;
  };
  const JudgedCase c = picture_case(Profile::strict, Unit::colour, 3, 9);
  CHECK(judge_case(c, answer_of(with_spots(9, 5)), references).status == Status::passed);   // as many as may be
  CHECK(judge_case(c, answer_of(with_spots(10, 5)), references).status == Status::failed);  // one more
  CHECK(judge_case(c, answer_of(with_spots(9, 1)), references).status == Status::failed);   // nine in a square
}

TEST_CASE("strict: a slightly shifted picture fails, and its credit is capped") {
  // Where even sharp edges are tolerated, nothing but the fitted shift tells.
  const JudgedCase c = picture_case(Profile::strict, Unit::colour, 60, 40);
  const StepReferences references = reference_of(right_picture());
  const CaseResult result = judge_case(c, answer_of(drawn_with([](Drawing& d) { d.offset_x = 0.12; })), references);
  REQUIRE(result.figures.at("over") <= 40);
  REQUIRE(result.figures.at("blob") == 0);
  CHECK(result.status == Status::failed);
  CHECK(result.score > 0);
  CHECK(result.score <= 4);
  CHECK(mentions(result.credit, {"at most 40 %"}));
}

TEST_CASE("strict: the default budget is smaller in a small picture") {
  JudgedCase c = picture_case();
  c.ask.size = {16, 16};
  Image reference(16, 16, {0.2f, 0.2f, 0.2f, 1});
  reference.at(0, 0) = {0.5f, 0.5f, 0.5f, 1};
  const StepReferences references = reference_of(reference);
  Image one = reference, two = reference;
  one.at(5, 5) = two.at(5, 5) = two.at(9, 12) = {0.9f, 0.9f, 0.9f, 1};
  CHECK(judge_case(c, answer_of(one), references).status == Status::passed);
  CHECK(judge_case(c, answer_of(two), references).status == Status::failed);
}

TEST_CASE("robust: edges may move, areas may not") {
  const JudgedCase c = picture_case(Profile::robust);
  const StepReferences references = reference_of(right_picture());
  const auto passes = [&](const Image& picture) {
    return judge_case(c, answer_of(picture), references).status == Status::passed;
  };
  for (const Drawn& row : right_rows()) {
    INFO(row.name);
    CHECK(passes(row.picture));
  }
  CHECK(passes(drawn_with([](Drawing& d) { d.offset_x = 0.25; })));
  CHECK_FALSE(passes(drawn_with([](Drawing& d) { d.offset_x = 2; })));
  CHECK_FALSE(passes(drawn_with([](Drawing& d) { d.no_shadow = true; })));
  CHECK_FALSE(passes(drawn_with([](Drawing& d) { d.no_ambient = true; })));
  CHECK_FALSE(passes(drawn_with([](Drawing& d) { d.hole_in_shadow = true; })));
}

TEST_CASE("exact: 8-bit levels, each equal") {
  JudgedCase c = picture_case(Profile::exact, Unit::encoded, 0, 0);
  c.ask.size = {64, 64};
  const Image right = dithered_ramp(64, false);
  const StepReferences references = reference_of(right);
  const auto status = [&](const Image& picture) { return judge_case(c, answer_of(picture), references).status; };
  CHECK(status(right) == Status::passed);
  CHECK(status(changed(right, [](const Rgba& p) { return Rgba{p.r * 0.9999f, p.g, p.b, 1}; })) == Status::passed);
  CHECK(status(dithered_ramp(64, true)) == Status::failed);
  Image one_off = right;
  one_off.at(40, 7).g = one_off.at(40, 7).g > 0 ? 0.0f : 1.0f;
  CHECK(status(one_off) == Status::failed);
}

TEST_CASE("strict: a transposed Bayer matrix fails too") {
  JudgedCase c = picture_case(Profile::strict, Unit::encoded, 3, 4);
  c.ask.size = {64, 64};
  const StepReferences references = reference_of(dithered_ramp(64, false));
  CHECK(judge_case(c, answer_of(dithered_ramp(64, true)), references).status == Status::failed);
}

TEST_CASE("units: directions in degrees, data in their own") {
  const Image normals = draw_normals({}), depth = draw_depth({});
  Drawing flipped;
  flipped.green_flipped = true;

  const JudgedCase directions = picture_case(Profile::strict, Unit::degrees, 1, 4);
  const StepReferences right_normals = reference_of(normals);
  const auto longer = [](const Rgba& p) {  // the same directions from vectors of length 0.8
    return Rgba{0.5f + 0.8f * (p.r - 0.5f), 0.5f + 0.8f * (p.g - 0.5f), 0.5f + 0.8f * (p.b - 0.5f), 1};
  };
  CHECK(judge_case(directions, answer_of(changed(normals, longer)), right_normals).status == Status::passed);
  const CaseResult bumps = judge_case(directions, answer_of(draw_normals(flipped)), right_normals);
  CHECK(bumps.status == Status::failed);
  CHECK(mentions(bumps.reason, {"degrees"}));

  const JudgedCase distances = picture_case(Profile::strict, Unit::number, 0.01, 4);
  const StepReferences right_depth = reference_of(depth);
  const auto offset = [&](float by) {
    return answer_of(changed(depth, [by](const Rgba& p) { return Rgba{p.r + by, p.g + by, p.b + by, 1}; }));
  };
  CHECK(judge_case(distances, offset(0.005f), right_depth).status == Status::passed);
  const CaseResult far = judge_case(distances, offset(0.05f), right_depth);
  CHECK(far.status == Status::failed);
  CHECK(mentions(far.reason, {"too large", "0.05"}));
}

TEST_CASE("several references: the best counts") {
  JudgedCase c = picture_case();
  StepReferences references("02-blinn-phong");
  Drawing other;
  other.no_ambient = true;
  CaseReferences right;
  right.pictures = {right_picture(), draw(other)};
  references.add("sphere", right);
  CHECK(judge_case(c, answer_of(right_picture()), references).status == Status::passed);
  CHECK(judge_case(c, answer_of(draw(other)), references).status == Status::passed);
  other.no_highlight = true;
  const CaseResult wrong = judge_case(c, answer_of(draw(other)), references);
  CHECK(wrong.status == Status::failed);
  CHECK(wrong.evidence->reference == compared_form(right.pictures[1], c));  // shown beside the one it is nearest to
}

}  // namespace
}  // namespace atelier::judge::test
