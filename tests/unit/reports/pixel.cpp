#include "judge/report/report_pixel.hpp"

#include <limits>
#include <nlohmann/json.hpp>

#include "catch.hpp"

using namespace atelier;
using namespace atelier::judge;

namespace {

JudgedCase compared_in(Unit unit, double delta) {
  JudgedCase how;
  how.unit = unit;
  how.delta = delta;
  return how;
}

/// A normal that points elsewhere, and so another colour.
PixelReport pixel_of_sphere() {
  PixelReport report{.step = "02-blinn-phong",
                     .case_name = "two-lights",
                     .title = "Two lights",
                     .at = {120, 33},
                     .size = {256, 128},
                     .scene = "sphere",
                     .settings = {{"light.count", 2}, {"specular.power", std::string("stable")}},
                     .implementations = {{"01-transforms", "solution"}, {"02-blinn-phong", "yours"}},
                     .visible = Visible::surface};
  report.rows = {{.output = "depth",
                  .how = compared_in(Unit::number, 1e-4),
                  .yours = Rgba{0.25f, 0.25f, 0.25f},
                  .right = Rgba{0.25f, 0.25f, 0.25f}},
                 {.output = "normal",
                  .how = compared_in(Unit::degrees, 0.5),
                  .yours = Rgba{1, 0.5f, 0.5f},
                  .right = Rgba{0.5f, 1, 0.5f},
                  .apart = 90,
                  .differs = true},
                 {.output = "colour",
                  .how = compared_in(Unit::colour, 3),
                  .yours = Rgba{1, 1, 1},
                  .right = Rgba{0.2159f, 0.2159f, 4},
                  .apart = 127,
                  .differs = true}};
  report.worst = report.at;
  return report;
}

std::string line_with(const std::string& text, const std::string& word) {
  const auto at = text.find(word);
  if (at == text.npos) return {};
  const auto begin = text.rfind('\n', at) + 1;
  return text.substr(begin, text.find('\n', at) - begin);
}

}  // namespace

TEST_CASE("a pixel's table has a line for each output, and marks the first that differs") {
  const std::string text = pixel_text(pixel_of_sphere(), {});
  INFO(text);
  CHECK(test::mentions(text, {"02-blinn-phong  two-lights  Two lights\n",
                              "pixel 120,33 of 256 x 128, from the upper left corner; it shows a surface\n",
                              "scene sphere, light.count = 2, specular.power = stable\n",
                              "with 01-transforms: solution", "The normal is the first to differ"}));
  CHECK(line_with(text, "output").find("solution") != std::string::npos);
  CHECK(line_with(text, "depth").starts_with(" + depth   0.25 "));
  CHECK(test::mentions(line_with(text, " normal "),
                       {" x normal", " 1 0 0 ", " 0 1 0 ", "90 degrees (0.5)", "<- the first to differ"}));
  CHECK(test::mentions(line_with(text, " colour "),
                       {" x colour", "1 1 1 [255 255 255]", "0.2159 0.2159 4 [128 128 255]", "127/255 (3)"}));
  CHECK(line_with(text, " colour ").find("<-") == std::string::npos);
}

TEST_CASE("where the pixel lies, and what its values stand beside") {
  PixelReport report = pixel_of_sphere();
  report.masked = true;
  report.region = "the highlight";
  report.visible = Visible::background;
  report.rows[0].beside = report.rows[1].beside = Beside::truth;
  report.rows[2].beside = Beside::reference;
  report.rows[0].right.reset();
  report.rows[1].yours.reset();
  report.rows[1].problem = "crashed: a signal in f";
  const std::string text = pixel_text(report, {});
  INFO(text);
  CHECK(test::mentions(text, {"in a mask: the case does not compare it", "in the region 'the highlight'",
                              "it shows the background", "\nnormal: crashed: a signal in f\n"}));
  CHECK(test::mentions(line_with(text, "output"), {"right"}));
  CHECK(line_with(text, "depth").starts_with("   depth"));  // neither right nor wrong
  CHECK(test::mentions(line_with(text, " normal "), {"truth  <- the first"}));
  CHECK(line_with(text, " colour ").ends_with("reference"));
}

TEST_CASE("a pixel as JSON has the values as a program writes them") {
  PixelReport report = pixel_of_sphere();
  report.rows[0].right.reset();
  report.rows[2].yours->r = std::numeric_limits<float>::quiet_NaN();
  report.rows[2].apart = std::numeric_limits<double>::infinity();
  report.functions = {"world_normal"};
  const auto json = nlohmann::json::parse(pixel_json(report));
  CHECK(json["pixel"] == nlohmann::json{120, 33});
  CHECK(json["settings"] == nlohmann::json{{"light.count", 2}, {"specular.power", "stable"}});
  CHECK(json["first"] == "normal");
  CHECK(json["functions"] == nlohmann::json{"world_normal"});
  const auto& rows = json["outputs"];
  REQUIRE(rows.size() == 3);
  CHECK(rows[0]["right"].is_null());
  CHECK(rows[0]["beside"].is_null());
  CHECK(rows[1]["yours"] == nlohmann::json{1.0, 0.5, 0.5});
  CHECK(rows[1]["unit"] == "degrees");
  CHECK(rows[1]["tolerance"] == 0.5);
  CHECK(rows[2]["yours"][0] == "nan");
  CHECK(rows[2]["apart"] == "inf");
  CHECK(rows[2]["differs"] == true);
}
