// Whole-picture hypotheses: each operation is found on a picture that it was applied to, and on no other.
#include "judge/explain/hypotheses.hpp"

#include <cmath>
#include <numbers>

#include "catch.hpp"
#include "image/colour.hpp"
#include "judge/compare/measure.hpp"
#include "judge/compare/verdict.hpp"
#include "synthetic.hpp"

namespace atelier::judge::test {
namespace {

using atelier::test::mentions;

std::optional<Hypothesis> explained(const Image& yours, const Image& reference, const JudgedCase& c) {
  const Image a = compared_form(yours, c), b = compared_form(reference, c);
  const Measurement measured = measure(a, b, c);
  REQUIRE_FALSE(measured.passed);
  return explain_whole_picture({yours, reference, a, b, c, measured.difference.mask});
}

/// A function of one channel, applied to all three.
std::function<Rgba(const Rgba&)> each(float (*value)(float)) {
  return [value](const Rgba& p) { return Rgba{value(p.r), value(p.g), value(p.b), p.a}; };
}

Image scaled(const Image& image, double by) {
  return changed(image, [by](const Rgba& p) { return Rgba{float(p.r * by), float(p.g * by), float(p.b * by), p.a}; });
}

struct PictureRow {
  const char* name;
  Image picture;
  std::string_view word;  ///< in the sentence
};

void check_picture_rows(const std::vector<PictureRow>& rows, const Image& reference, const JudgedCase& c) {
  for (const PictureRow& row : rows) {
    INFO(row.name << ": " << row.word);
    const auto found = explained(row.picture, reference, c);
    REQUIRE(found.has_value());
    CHECK(found->name == row.name);
    INFO(found->sentence);
    CHECK(mentions(found->sentence, {row.word}));
    CHECK_FALSE(found->hint.empty());
  }
}

TEST_CASE("colours: mirrors, shifts, channels, encodings and gains are found") {
  const Image right = draw({});
  const int last = right.width() - 1;
  std::vector<PictureRow> rows{
      {"flipped-y", moved(right, [=](int x, int y) { return glm::ivec2(x, last - y); }), "upside down"},
      {"flipped-x", moved(right, [=](int x, int y) { return glm::ivec2(last - x, y); }), "left to right"},
      {"rotated-180", moved(right, [=](int x, int y) { return glm::ivec2(last - x, last - y); }), "180 degrees"},
      {"transposed", moved(right, [](int x, int y) { return glm::ivec2(y, x); }), "diagonal"},
      {"shifted", moved(right, [](int x, int y) { return glm::ivec2(x - 1, y); }), "to the right"},
      {"shifted", moved(right, [](int x, int y) { return glm::ivec2(x + 1, y - 1); }), "to the left and down"},
      {"shifted", moved(right, [](int x, int y) { return glm::ivec2(x, y + 1); }), "up"},
      {"swapped-channels",
       changed(right,
               [](const Rgba& p) {
                 return Rgba{p.b, p.g, p.r, p.a};
               }),
       "red and blue"},
      {"swapped-channels",
       changed(right,
               [](const Rgba& p) {
                 return Rgba{p.g, p.b, p.r, p.a};
               }),
       "cycle"},
      {"encoded-twice", changed(right, each([](float v) { return srgb_encode(v); })), "twice"},
      {"not-encoded", changed(right, each([](float v) { return srgb_decode(v); })), "once too often"},
      {"gain", scaled(right, 2), "2 times too bright (that is 2)"},
      {"gain", scaled(right, 1 / std::numbers::pi), "3.14 times too dark (that is 1/pi)"},
      {"gain", scaled(right, 1.1), "1.1 times too bright"},
  };
  check_picture_rows(rows, right, picture_case());
}

TEST_CASE("colours: an operation is found under the noise of another processor, and with wrong edges") {
  const Image right = draw({});
  const int last = right.width() - 1;
  Drawing jittered;
  jittered.offset_x = jittered.offset_y = 1 / 64.0;
  const Image upside_down = moved(with_noise(draw(jittered), 1), [=](int x, int y) { return glm::ivec2(x, last - y); });
  check_picture_rows({{"flipped-y", upside_down, "upside down"}}, right, picture_case());
}

TEST_CASE("encoded colours: linear values instead of encoded ones") {
  const Image linear = draw({}), encoded = changed(linear, each([](float v) { return srgb_encode(v); }));
  const JudgedCase c = picture_case(Profile::strict, Unit::encoded);
  check_picture_rows({{"not-encoded", linear, "linear values"},
                      {"encoded-twice", changed(encoded, each([](float v) { return srgb_encode(v); })), "twice"}},
                     encoded, c);
}

TEST_CASE("directions: signs and packing") {
  const Image right = draw_normals({});
  check_picture_rows({{"negated", changed(right, each([](float v) { return 1 - v; })), "all three"},
                      {"negated-y",
                       changed(right,
                               [](const Rgba& p) {
                                 return Rgba{p.r, 1 - p.g, p.b, 1};
                               }),
                       "green"},
                      {"negated-z",
                       changed(right,
                               [](const Rgba& p) {
                                 return Rgba{p.r, p.g, 1 - p.b, 1};
                               }),
                       "z is"},
                      {"not-packed", changed(right, each([](float v) { return 2 * v - 1; })), "n/2 + 1/2"},
                      {"packed-twice", changed(right, each([](float v) { return v / 2 + 0.5f; })), "twice"},
                      {"flipped-y", moved(right, [](int x, int y) { return glm::ivec2(x, 191 - y); }), "upside down"}},
                     right, picture_case(Profile::strict, Unit::degrees, 1, 4));
}

TEST_CASE("data: ranges and factors") {
  const Image depth = draw_depth({});
  const Image right = changed(depth, each([](float v) { return v / 41; }));
  check_picture_rows({{"complement", changed(right, each([](float v) { return 1 - v; })), "1 - v"},
                      {"signed-range", changed(right, each([](float v) { return 2 * v - 1; })), "-1..1"},
                      {"halved-range", changed(right, each([](float v) { return v / 2 + 0.5f; })), "v/2 + 1/2"},
                      {"gain", scaled(right, 1 / 3.0), "1/3"}},
                     right, picture_case(Profile::strict, Unit::number, 0.001, 4));
}

TEST_CASE("other errors are not explained by an operation") {
  const Image right = draw({});
  const JudgedCase c = picture_case();
  struct Change {
    const char* name;
    void (*apply)(Drawing&);
  };
  for (const Change& change : {Change{"exponent", [](Drawing& d) { d.exponent = 36; }},
                               Change{"half a texel", [](Drawing& d) { d.texel_offset = 0.5; }},
                               Change{"bumps", [](Drawing& d) { d.green_flipped = true; }},
                               Change{"no ambient", [](Drawing& d) { d.no_ambient = true; }},
                               Change{"no cosine", [](Drawing& d) { d.no_cosine = true; }},
                               Change{"no shadow", [](Drawing& d) { d.no_shadow = true; }},
                               Change{"another camera", [](Drawing& d) { d.yaw = -0.4; }}}) {
    INFO(change.name);
    Drawing drawing;
    change.apply(drawing);
    CHECK_FALSE(explained(draw(drawing), right, c).has_value());
  }
  CHECK_FALSE(explained(with_line(right, 65), right, c).has_value());
}

TEST_CASE("a verdict starts with the hypothesis, and caps its credit") {
  const Image right = draw({});
  StepReferences references("02-blinn-phong");
  CaseReferences accepted;
  accepted.pictures.push_back(right);
  references.add("sphere", accepted);
  const CaseResult result = judge_case(picture_case(),
                                       answer_of(changed(right,
                                                         [](const Rgba& p) {
                                                           return Rgba{p.b, p.g, p.r, p.a};
                                                         })),
                                       references);
  CHECK(result.hypothesis == "swapped-channels");
  CHECK(result.reason.starts_with("Channels are exchanged: red and blue."));
  CHECK(result.score <= 4);
}

}  // namespace
}  // namespace atelier::judge::test
