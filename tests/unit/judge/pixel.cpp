#include "judge/explain/pixel.hpp"

#include "catch.hpp"
#include "synthetic.hpp"

namespace atelier::judge::test {
namespace {

using atelier::test::error_of;
using atelier::test::mentions;

/// What a step with shadows and a chain of passes lists.
const std::vector<OutputSpec> outputs = {
    {"colour", Encoding::linear, "", Stage::colour},       {"shadow_coordinate", Encoding::data, "", Stage::light},
    {"shadow_factor", Encoding::data, "", Stage::light},   {"shadow_map", Encoding::data, "", Stage::other_view},
    {"recorded_normal", Encoding::data, "", Stage::aside}, {"bright", Encoding::linear, "", Stage::pass},
    {"bloom", Encoding::linear, "", Stage::pass},          {"encoded", Encoding::srgb, "", Stage::after_colour},
    {"edges", Encoding::data, "", Stage::after_colour},    {"position", Encoding::data, "", Stage::surface},
    {"normal", Encoding::data, "", Stage::surface},
};

const OutputSpec& output(const std::string& name) {
  return *std::ranges::find(outputs, name, &OutputSpec::name);
}

std::vector<std::string> names_to(const std::string& own) {
  std::vector<std::string> names;
  for (const OutputSpec& each : pipeline_to(own, outputs)) names.push_back(each.name);
  return names;
}

JudgedCase case_of(const std::string& shown, Unit unit = Unit::colour, double delta = 3) {
  JudgedCase c = picture_case(Profile::strict, unit, delta);
  c.ask.output = shown;
  return c;
}

Rgba code_of(const glm::dvec3& n) {
  return {float(n.x / 2 + 0.5), float(n.y / 2 + 0.5), float(n.z / 2 + 0.5), 1};
}

/// Row of one pixel: yours beside this value of the solution.
PixelRow row_of(const std::string& name, const Rgba& yours, const Rgba& right, const JudgedCase& c) {
  const Image picture(1, 1, right);
  return compare_pixel(output(name), comparison_of(output(name), c, {}), answer_of(Image(1, 1, yours)),
                       {Beside::solution, {&picture}}, {});
}

TEST_CASE("the outputs that lead to another, in the order of the pipeline") {
  using Names = std::vector<std::string>;
  CHECK(names_to("position") == Names{"position"});
  CHECK(names_to("normal") == Names{"position", "normal"});
  CHECK(names_to("shadow_factor") == Names{"position", "normal", "shadow_coordinate", "shadow_factor"});
  CHECK(names_to("bright") == Names{"position", "normal", "shadow_coordinate", "shadow_factor", "bright"});
  CHECK(names_to("colour") ==
        Names{"position", "normal", "shadow_coordinate", "shadow_factor", "bright", "bloom", "colour"});
  CHECK(names_to("edges") ==
        Names{"position", "normal", "shadow_coordinate", "shadow_factor", "bright", "bloom", "colour", "edges"});
  CHECK(names_to("recorded_normal") == Names{"position", "normal", "recorded_normal"});
  CHECK(names_to("shadow_map") == Names{"shadow_map"});
  CHECK(mentions(error_of([] { names_to("normals"); }), {"'normals'", "did you mean 'normal'?"}));
}

TEST_CASE("an output is compared as the case, as another case that judges it, or as usual") {
  const JudgedCase factor = case_of("shadow_factor", Unit::number, 0.05);
  const JudgedCase exact = picture_case(Profile::exact);
  struct Row {
    const char* output;
    JudgedCase c;
    Unit unit;
    double delta;
  };
  for (const Row& row : {
           Row{"shadow_factor", case_of("shadow_factor", Unit::number, 0.3), Unit::number, 0.3},  // its own
           Row{"shadow_factor", case_of("colour"), Unit::number, 0.05},                           // another case's
           Row{"shadow_coordinate", case_of("colour"), Unit::number, 0.002},
           Row{"position", case_of("colour"), Unit::number, 0.01},
           Row{"normal", case_of("colour"), Unit::degrees, 0.5},
           Row{"normal", case_of("normal"), Unit::degrees, 0.5},  // a case that judges its codes as colours
           Row{"normal", case_of("normal", Unit::degrees, 2), Unit::degrees, 2},
           Row{"bright", case_of("colour"), Unit::colour, 3},
           Row{"bright", case_of("shadow_factor", Unit::number, 0.3), Unit::colour, 3},
           Row{"encoded", case_of("colour"), Unit::encoded, 3},
       }) {
    INFO(row.output << " of a case of " << row.c.ask.output);
    const JudgedCase how = comparison_of(output(row.output), row.c, {exact, factor});
    CHECK(how.unit == row.unit);
    CHECK(how.delta == row.delta);
    CHECK(how.profile == Profile::strict);
  }
  CHECK(comparison_of(output("colour"), exact, {exact}).profile == Profile::exact);
}

TEST_CASE("a pixel is compared in its unit, with its tolerance") {
  const JudgedCase c = case_of("colour");
  const glm::dvec3 up(0, 1, 0), tilted(std::sin(0.25), std::cos(0.25), 0);
  const PixelRow normal = row_of("normal", code_of(tilted), code_of(up), c);
  CHECK(normal.differs);
  CHECK(normal.apart == Approx(14.32).margin(0.03));  // 0.25 radians; compare.hpp: accurate to 0.02 degrees
  CHECK_FALSE(row_of("normal", code_of({0.006, 1, 0}), code_of(up), c).differs);
  CHECK(row_of("normal", code_of({0.012, 1, 0}), code_of(up), c).differs);
  CHECK_FALSE(row_of("position", {5.009f, 0, 1}, {5, 0, 1}, c).differs);
  CHECK(row_of("position", {5.02f, 0, 1}, {5, 0, 1}, c).differs);
  CHECK_FALSE(row_of("bright", {0.215f, 0.2f, 0.2f}, {0.21f, 0.2f, 0.2f}, c).differs);
  const PixelRow colour = row_of("bright", {1, 0, 0}, {0, 0, 0}, c);
  CHECK(colour.apart == Approx(255));
  CHECK(colour.differs);
  CHECK(row_of("bright", {nan, 0, 0}, {0, 0, 0}, c).differs);
  CHECK_FALSE(row_of("bright", {7, 2, 1}, {1, 1, 1}, c).differs);  // both white

  JudgedCase exposed = c;
  exposed.exposure = 0.01;
  CHECK_FALSE(row_of("bright", {0.3f, 0, 0}, {0.25f, 0, 0}, exposed).differs);
}

TEST_CASE("beside an edge the truth is the range of the pixels around") {
  const JudgedCase how = comparison_of(output("position"), case_of("colour"), {});
  Image truth(8, 8, {0, 0, 0, 1});
  for (int y = 0; y < 8; ++y)
    for (int x = 4; x < 8; ++x) truth.at(x, y) = {1, 0, 0, 1};
  const auto differs = [&](Position at, float x, Beside beside) {
    return compare_pixel(output("position"), how, answer_of(Image(8, 8, {x, 0, 0, 1})), {beside, {&truth}}, at).differs;
  };
  CHECK_FALSE(differs({3, 3}, 1, Beside::truth));  // the edge is half a pixel away
  CHECK(differs({2, 3}, 1, Beside::truth));
  CHECK(differs({3, 3}, 1, Beside::solution));  // the same driver draws both
  CHECK(differs({3, 3}, 1.5f, Beside::truth));
  CHECK_FALSE(differs({7, 7}, 1, Beside::truth));  // a corner has three neighbours
  CHECK(differs({0, 0}, 1, Beside::truth));
}

TEST_CASE("of several right pictures the nearest counts") {
  const Image red(1, 1, {1, 0, 0, 1}), green(1, 1, {0, 1, 0, 1});
  const PixelRow row =
      compare_pixel(output("colour"), case_of("colour"), answer_of(green), {Beside::reference, {&red, &green}}, {});
  CHECK_FALSE(row.differs);
  CHECK(row.right == green.at(0, 0));
}

TEST_CASE("a missing value differs if there is a right one") {
  Answer crashed{.ended = Answer::Ended::crashed, .error = "a signal in f"};
  const Image right(1, 1, {0, 0, 0, 1});
  const PixelRow row = compare_pixel(output("colour"), case_of("colour"), crashed, {Beside::solution, {&right}}, {});
  CHECK(row.differs);
  CHECK_FALSE(row.yours);
  CHECK(row.problem == "crashed: a signal in f");
  CHECK_FALSE(compare_pixel(output("colour"), case_of("colour"), crashed, {}, {}).differs);
}

TEST_CASE("what a pixel shows") {
  Image things(6, 6, {0, 0, 0, 1});
  for (int y = 0; y < 6; ++y)
    for (int x = 3; x < 6; ++x) things.at(x, y) = {2, 2, 2, 1};
  CHECK(visible_at(things, {0, 0}) == Visible::background);
  CHECK(visible_at(things, {5, 5}) == Visible::surface);
  CHECK(visible_at(things, {2, 2}) == Visible::edge);
  CHECK(visible_at(things, {3, 0}) == Visible::edge);
}

TEST_CASE("the functions that make an output") {
  JudgedCase own = case_of("colour"), factor = case_of("shadow_factor", Unit::number, 0.1), soft = factor;
  own.functions = {"shade"};
  factor.functions = {"pcf", "compare_depth"};
  soft.functions = {"pcf", "pcss"};
  const std::vector<JudgedCase> step = {own, factor, soft};
  using Names = std::vector<std::string>;
  CHECK(functions_behind("colour", own, {"pcf"}, step) == Names{"shade"});
  CHECK(functions_behind("shadow_factor", own, {}, step) == Names{"pcf", "compare_depth", "pcss"});
  CHECK(functions_behind("shadow_factor", own, {"pcss", "shade"}, step) == Names{"pcss"});
  own.functions = {"compare_depth"};  // tested although its skeleton would do
  CHECK(functions_behind("shadow_factor", own, {"pcss"}, step) == Names{"compare_depth", "pcss"});
  CHECK(functions_behind("normal", own, {}, step).empty());
}

TEST_CASE("the sentence names the first that differs") {
  const JudgedCase c = case_of("colour");
  const Rgba up = code_of({0, 1, 0}), tilted = code_of({std::sin(0.25), std::cos(0.25), 0}), white{1, 1, 1},
             grey{0.2f, 0.2f, 0.2f};
  PixelReport report{.step = "02-blinn-phong", .at = {3, 4}};
  report.rows = {row_of("position", {1, 2, 3}, {1, 2, 3}, c), row_of("normal", tilted, up, c),
                 row_of("colour", white, grey, c)};
  report.worst = Position{7, 8};
  REQUIRE(first_to_differ(report) == &report.rows[1]);
  report.functions_of = "01-transforms";
  report.functions = {"world_normal"};
  CHECK(pixel_sentence(report) ==
        "The normal is the first to differ: yours points 14.3 degrees away (0.5 degrees are allowed). Look at "
        "world_normal (01-transforms), and at what it calls.");

  SECTION("of this step, several") {
    report.functions_of = report.step;
    report.functions = {"a", "b"};
    CHECK(mentions(pixel_sentence(report), {"Look at a, b, and at what they call."}));
  }
  SECTION("a colour, and a position") {
    report.rows[1] = row_of("normal", up, up, c);
    CHECK(mentions(pixel_sentence(report), {"The colour is the first to differ: yours is off by 131/255 (3/255 are"}));
    report.rows[0] = row_of("position", {1, 2.5f, 3}, {1, 2, 3}, c);
    CHECK(mentions(pixel_sentence(report), {"The position is the first to differ: yours is off by 0.5 (0.01 is"}));
  }
  SECTION("the case's own output agrees") {
    report.rows[2] = row_of("colour", grey, grey, c);
    CHECK(mentions(pixel_sentence(report),
                   {"The normal is the first", "own output, colour, does not differ here", "differs most at 7,8"}));
  }
  SECTION("nothing differs") {
    report.rows = {row_of("colour", grey, grey, c)};
    CHECK(first_to_differ(report) == nullptr);
    CHECK(pixel_sentence(report) == "Nothing differs at this pixel. The picture differs most at 7,8.");
    report.worst.reset();
    CHECK(mentions(pixel_sentence(report), {"No pixel of the picture differs"}));
  }
  SECTION("a value that is not finite, or missing") {
    report.rows[0] = row_of("position", {nan, 2, 3}, {1, 2, 3}, c);
    CHECK(mentions(pixel_sentence(report), {"The position", "not a finite number"}));
    report.rows[0].yours.reset();
    report.rows[0].problem = "timeout: too long";
    CHECK(mentions(pixel_sentence(report), {"The position", "yours is missing: timeout: too long"}));
  }
  SECTION("the truth is exact") {
    report.rows[1].beside = Beside::truth;
    report.truth_differs = "Mipmaps blur.";
    CHECK(
        mentions(pixel_sentence(report), {"ray-traced truth, which a right step may only approximate: Mipmaps blur."}));
  }
  SECTION("a program that draws nothing") {
    for (PixelRow& row : report.rows) {
      row.yours.reset();
      row.problem = "build failed: line 3";
    }
    CHECK(drew_nothing(report));
    CHECK(first_to_differ(report) == nullptr);
    CHECK(pixel_sentence(report) == "Your program drew nothing: build failed: line 3");
  }
  SECTION("a pass may read other pixels") {
    report.rows = {row_of("bloom", white, grey, c)};
    CHECK(mentions(pixel_sentence(report), {"The output 'bloom' is the first", "A pass may read other pixels"}));
  }
  SECTION("nothing to compare with") {
    report.rows = {compare_pixel(output("colour"), c, answer_of(Image(1, 1, grey)), {}, {})};
    CHECK(pixel_sentence(report) == "There is nothing to compare with.");
  }
}

}  // namespace
}  // namespace atelier::judge::test
