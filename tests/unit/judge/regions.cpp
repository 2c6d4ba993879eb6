// Masks and weighted regions: what is ignored, what is not, and how pixels are weighted.
#include "judge/compare/regions.hpp"

#include <cmath>
#include <limits>

#include "catch.hpp"
#include "judge/compare/measure.hpp"
#include "judge/compare/verdict.hpp"
#include "synthetic.hpp"

namespace atelier::judge::test {
namespace {

using atelier::test::mentions;

constexpr Rectangle corner{8, 16, 24, 12};

/// The picture with a rectangle that is much too bright.
Image spoiled(Image picture, const Rectangle& at) {
  for (int y = at.y; y < at.y + at.height; ++y)
    for (int x = at.x; x < at.x + at.width; ++x) picture.at(x, y) = {0.9f, 0.2f, 0.9f, 1};
  return picture;
}

StepReferences references_of(const JudgedCase& c, const Image& picture) {
  StepReferences references("02-blinn-phong");
  CaseReferences right;
  right.pictures = {picture};
  references.add(c.ask.name, right);
  return references;
}

TEST_CASE("masked pixels are not compared, all others are") {
  const Image right = draw({});
  struct Row {
    const char* name;
    Image yours;
    bool passes;
  };
  Image broken = right;
  broken.at(corner.x, corner.y).g = std::numeric_limits<float>::quiet_NaN();
  const Row rows[]{
      {"wrong all over the mask", spoiled(right, corner), true},
      {"one column more", spoiled(right, {corner.x, corner.y, corner.width + 1, corner.height}), false},
      {"one row more", spoiled(right, {corner.x, corner.y - 1, corner.width, corner.height + 1}), false},
      {"elsewhere", spoiled(right, {100, 100, 24, 12}), false},
      {"a NaN inside it", broken, false},
  };
  for (Profile profile : {Profile::strict, Profile::exact}) {
    JudgedCase c =
        picture_case(profile, Unit::colour, profile == Profile::exact ? 0 : 3, profile == Profile::exact ? 0 : 4);
    c.mask = {corner};
    const StepReferences references = references_of(c, right);
    for (const Row& row : rows) {
      INFO(row.name << ", " << to_string(profile));
      const CaseResult result = judge_case(c, answer_of(row.yours), references);
      INFO(result.reason);
      CHECK((result.status == Status::passed) == row.passes);
    }
    c.mask.clear();
    CHECK(judge_case(c, answer_of(rows[0].yours), references).status == Status::failed);
  }
}

TEST_CASE("fractions: masked pixels do not count, regions count by their weights") {
  Mask over(10, 10);
  for (int x = 0; x < 10; ++x) over.set(x, 0, true);  // the upper row
  const std::vector<Region> heavy{{"the left half", {0, 0, 5, 10}, 3}}, light{{"the top", {0, 0, 10, 1}, 0.5}};
  CHECK(weighted_fraction(over, {}, {}) == Approx(0.1));
  CHECK(weighted_fraction(over, {{0, 0, 5, 5}}, {}) == Approx(5 / 75.0));
  CHECK(weighted_fraction(over, {}, heavy) == Approx(20 / 200.0));
  CHECK(weighted_fraction(over, {}, light) == Approx(5 / 95.0));
  CHECK(weighted_fraction(over, {{5, 0, 5, 1}}, heavy) == Approx(15 / (150.0 + 45)));
  CHECK(weighted_fraction(over, {{0, 0, 10, 1}, {0, 0, 5, 1}}, light) == 0);
}

TEST_CASE("a mistake in a region that counts more costs more, and the verdict says that parts are weighted") {
  const Image right = draw({});
  JudgedCase c = picture_case();
  const StepReferences references = references_of(c, right);
  const Answer answer = answer_of(spoiled(right, corner));
  const CaseResult plain = judge_case(c, answer, references);
  c.regions = {{"the corner", corner, 5}};
  const CaseResult heavy = judge_case(c, answer, references);
  c.regions = {{"the corner", corner, 0.2}};
  const CaseResult light = judge_case(c, answer, references);
  CHECK(heavy.score < plain.score);
  CHECK(plain.score < light.score);
  CHECK(mentions(heavy.credit, {"some count more than others"}));
  CHECK(plain.credit.find("counting") == std::string::npos);
  // Passing stays a matter of every pixel.
  CHECK(light.status == Status::failed);
}

}  // namespace
}  // namespace atelier::judge::test
