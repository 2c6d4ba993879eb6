// Naming is tested on other data than the atlas: other cameras, other lights, and other spellings of a mistake.
#include "judge/explain/naming.hpp"
#include "judge/explain/causes.hpp"

#include <algorithm>

#include "catch.hpp"
#include "judge/compare/measure.hpp"
#include "judge/compare/verdict.hpp"
#include "synthetic.hpp"

namespace atelier::judge::test {
namespace {

struct Wrong {
  const char* name;
  void (*apply)(Drawing&);
  void (*respelled)(Drawing&);  ///< the same mistake, made in another way
};

const std::vector<Wrong> wrongs{
    {"exponent", [](Drawing& d) { d.exponent = 36; }, [](Drawing& d) { d.exponent = 36.5; }},
    {"half-texel", [](Drawing& d) { d.texel_offset = 0.5; }, [](Drawing& d) { d.texel_offset = 0.48; }},
    {"nearest", [](Drawing& d) { d.nearest = true; }, [](Drawing& d) { d.nearest = d.reformulated = true; }},
    {"green", [](Drawing& d) { d.green_flipped = true; }, [](Drawing& d) { d.green_flipped = d.reformulated = true; }},
    {"rv-for-nh", [](Drawing& d) { d.mirrored_for_half = true; },
     [](Drawing& d) { d.mirrored_for_half = true, d.exponent = 31; }},
    {"no-ambient", [](Drawing& d) { d.no_ambient = true; }, [](Drawing& d) { d.no_ambient = d.reformulated = true; }},
    {"no-highlight", [](Drawing& d) { d.no_highlight = true; }, [](Drawing& d) { d.exponent = 1e5; }},
    {"no-cosine", [](Drawing& d) { d.no_cosine = true; }, [](Drawing& d) { d.no_cosine = d.reformulated = true; }},
    {"no-shadow", [](Drawing& d) { d.no_shadow = true; }, [](Drawing& d) { d.no_shadow = d.reformulated = true; }},
};

/// A picture in the atlas' form, rounded to 8 bits as a PNG would.
Image atlas_form(const Image& linear, bool stored) {
  const JudgedCase c = picture_case();
  const Image form = compared_form(linear, c);
  Image half = make_atlas_picture(form, form, c.unit);
  if (!stored) return half;
  return changed(half, [](const Rgba& p) {
    const auto level = [](float v) { return float(int(v * 255 + 0.5f)) / 255; };
    return Rgba{level(p.r), level(p.g), level(p.b), 1};
  });
}

Image draw_wrong(Drawing drawing, void (*apply)(Drawing&)) {
  apply(drawing);
  return draw(drawing);
}

std::vector<AtlasPicture> atlas_of(const Drawing& view, const char* without = "") {
  std::vector<AtlasPicture> atlas;
  const Image right = atlas_form(draw(view), true);
  for (const Wrong& wrong : wrongs)
    if (std::string(without) != wrong.name)
      atlas.push_back({wrong.name, atlas_form(draw_wrong(view, wrong.apply), true), right, true});
  return atlas;
}

std::string name_of(const Image& yours, const Image& right, const std::vector<AtlasPicture>& atlas) {
  const auto found = recognise(rank_mistakes(atlas_form(yours, false), atlas_form(right, false), atlas));
  return found ? found->mistake : "";
}

TEST_CASE("the same view: every mistake is recognised in another spelling, and with noise") {
  const Drawing view;
  const std::vector<AtlasPicture> atlas = atlas_of(view);
  const Image right = draw(view);
  for (const Wrong& wrong : wrongs) {
    INFO(wrong.name);
    CHECK(name_of(draw_wrong(view, wrong.respelled), right, atlas) == wrong.name);
    CHECK(name_of(with_noise(draw_wrong(view, wrong.apply), 1), right, atlas) == wrong.name);
  }
}

TEST_CASE("the same view: mistakes outside the atlas get no name") {
  const Drawing view;
  const Image right = draw(view);
  for (const Wrong& wrong : wrongs) {
    INFO(wrong.name);
    CHECK(name_of(draw_wrong(view, wrong.apply), right, atlas_of(view, wrong.name)) == "");
  }
  // Two mistakes at once are neither.
  Drawing both;
  both.no_highlight = both.green_flipped = true;
  CHECK(name_of(draw(both), right, atlas_of(view)) == "");
  CHECK(name_of(with_noise(right, 1), right, atlas_of(view)) == "");
}

TEST_CASE("two mistakes that look alike get no name") {
  const Drawing view;
  const Image right = draw(view);
  std::vector<AtlasPicture> atlas = atlas_of(view);
  atlas.push_back(
      {"half-texel-too", atlas_form(draw_wrong(view, wrongs[1].respelled), true), atlas[0].reference, true});
  CHECK(name_of(draw_wrong(view, wrongs[1].apply), right, atlas) == "");
  CHECK(name_of(draw_wrong(view, wrongs[2].apply), right, atlas) == "nearest");
}

TEST_CASE("other views: names are right, most mistakes get one, and none when theirs is not in the atlas") {
  std::vector<AtlasPicture> atlas = atlas_of({});
  for (AtlasPicture& entry : atlas) entry.same_view = false;
  int named = 0, asked = 0;
  for (double yaw : {0.5, 0.9, -0.6, 2.5})
    for (double light : {0.9, 1.3}) {
      Drawing view;
      view.yaw = yaw;
      view.light_yaw = light;
      const Image right = draw(view);
      for (const Wrong& wrong : wrongs) {
        INFO(wrong.name << " from " << yaw << " lit from " << light);
        const Image yours = draw_wrong(view, wrong.apply);
        const std::string name = name_of(yours, right, atlas);
        CHECK((name.empty() || name == wrong.name));
        named += name == wrong.name;
        ++asked;
        std::vector<AtlasPicture> others;
        std::copy_if(atlas.begin(), atlas.end(), std::back_inserter(others),
                     [&](const AtlasPicture& entry) { return entry.mistake != wrong.name; });
        CHECK(name_of(yours, right, others) == "");
      }
    }
  CHECK(asked == 72);
  CHECK(named >= 48);  // two of three: highlights half a turn away look like nothing in the atlas, and get no name
}

TEST_CASE("an atlas picture has half the size, rounded up, and keeps the range of data") {
  const Image odd(5, 3, {0.25f, 0.5f, 0.75f, 1});
  const Image half = make_atlas_picture(odd, odd, Unit::colour);
  CHECK(half.width() == 3);
  CHECK(half.height() == 2);
  CHECK(half.at(2, 1) == Rgba{0.25f, 0.5f, 0.75f, 1});

  Image depth(4, 4, {10, 10, 10, 1}), far(4, 4, {1000, 10, -1000, 1});
  depth.at(0, 0) = depth.at(1, 0) = depth.at(0, 1) = depth.at(1, 1) = {30, 30, 30, 1};
  const Image mapped = make_atlas_picture(depth, depth, Unit::number);
  CHECK(mapped.at(0, 0).r == Approx(0.75));  // its own range 10..30 fills the middle half
  CHECK(mapped.at(1, 1).r == Approx(0.25));
  const Image clamped = make_atlas_picture(far, depth, Unit::number);
  CHECK(clamped.at(0, 0).r == 1);
  CHECK(clamped.at(0, 0).b == 0);
}

TEST_CASE("a verdict names the mistake, with its sentence, its hint and its picture") {
  Mistake known;
  known.name = "no-shadow";
  known.sentence = "Nothing casts a shadow.";
  known.hint = "Is the depth map bound?";
  StepReferences references("03-shadow-mapping", {known});
  CaseReferences right;
  right.pictures.push_back(draw({}));
  references.add("sphere", right, {atlas_of({}), {}});
  const JudgedCase c = picture_case();
  StepResult step;
  step.cases = {judge_case(c, answer_of(draw_wrong({}, [](Drawing& d) { d.no_shadow = true; })), references)};
  explain_step(step, {c}, references);
  const CaseResult& result = step.cases[0];
  CHECK(result.mistake == "no-shadow");
  CHECK(result.mistake_sentence == known.sentence);
  CHECK(result.hint == known.hint);
  CHECK(result.figures.at("nearness") < max_nearness);
  REQUIRE(result.evidence.has_value());
  REQUIRE(result.evidence->mistake.has_value());
  CHECK(result.evidence->mistake->width() == 96);
}

TEST_CASE("probes: a mistake is named by its numbers, if no other mistake has the same") {
  JudgedCase c;
  c.profile = Profile::values;
  c.tolerance.absolute = 1e-3;
  c.ask.inputs.resize(2);
  const std::map<std::string, std::vector<Numbers>> wrong{
      {"doubled", {{2, 4}, {6, 8}}}, {"divides-by-zero", {{1, nan}, {3, 4}}}, {"zero", {{0, 0}, {0, 0}}}};
  CHECK(recognise_values({{2.0005, 4}, {6, 8}}, wrong, c) == std::vector<std::string>{"doubled"});
  CHECK(recognise_values({{1, nan}, {3, 4}}, wrong, c) == std::vector<std::string>{"divides-by-zero"});
  CHECK(recognise_values({{2, 4}, {6, 9}}, wrong, c).empty());
  CHECK(recognise_values({{2, 4}}, wrong, c).empty());
  auto twice = wrong;
  twice["also-zero"] = {{0, 0}, {0, 0}};
  CHECK(recognise_values({{0, 0}, {0, 0}}, twice, c).size() == 2);
}

}  // namespace
}  // namespace atelier::judge::test
