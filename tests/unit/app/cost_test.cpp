// The cost of a picture: counted, timed on request, and printed.
#include "app/cost.hpp"

#include <nlohmann/json.hpp>
#include <sstream>

#include "app/cases.hpp"
#include "case/exchange.hpp"
#include "catch.hpp"
#include "studio.hpp"

namespace {

using namespace atelier;
using test::error_of;
using test::mentions;
using test::small_picture;
using test::Studio;

}  // namespace

TEST_CASE("the median of an even number is between the middle two", "[cost]") {
  const FrameTimings one = timings_of({0.25}), even = timings_of({4, 1, 3, 2}), odd = timings_of({9, 1, 2});
  CHECK(one.count == 1);
  CHECK(one.median_s == 0.25);
  CHECK(even.median_s == 2.5);
  CHECK(even.least_s == 1);
  CHECK(even.most_s == 4);
  CHECK(odd.median_s == 2);
  CHECK(mentions(error_of([] { timings_of({}); }), {"no frame"}));
}

TEST_CASE("a picture's cost does not include loading its scene", "[cost]") {
  Studio studio;
  studio.painter->paint(small_picture());
  const DrawingCost& cost = studio.painter->cost();
  CHECK(cost.gl.passes == 1);
  CHECK(cost.gl.draws == 1);
  CHECK(cost.gl.triangles == 12);
  CHECK(cost.gl.vertices == 36);
  CHECK(cost.gl.variants == 1);
  CHECK(cost.gl.programs_linked == 1);
  CHECK(cost.gl.target_bytes == 32 * 24 * (16 + 4));  // floats and 24 bits of depth, stored in 32
  CHECK(cost.gl.texture_bytes == 0);
  CHECK(cost.gl.allocated_bytes == 0);
  CHECK(cost.scene.nodes == 1);
  CHECK(cost.scene.matrices == 2);
  CHECK_FALSE(cost.frames);
  REQUIRE_FALSE(cost.groups.empty());
  CHECK(cost.groups[0] == GlGroup{.depth = 0, .name = "frame", .passes = 1, .draws = 1, .triangles = 12});
}

TEST_CASE("timed frames come after two frames of warm-up, and look the same", "[cost]") {
  Studio studio;
  const Image once = studio.painter->paint(small_picture());
  CHECK(studio.step.draws == 1);
  studio.painter->time_frames(5);
  CHECK(studio.painter->paint(small_picture()) == once);
  CHECK(studio.step.draws == 1 + 2 + 5);
  const DrawingCost& cost = studio.painter->cost();
  REQUIRE(cost.frames);
  CHECK(cost.frames->count == 5);
  CHECK(cost.frames->least_s > 0);
  CHECK(cost.frames->least_s <= cost.frames->median_s);
  CHECK(cost.frames->median_s <= cost.frames->most_s);
  CHECK(cost.gl.draws == 1);  // of one frame, not of all
  CHECK(cost.gl.programs_linked == 0);
  CHECK(cost.scene.matrices == 0);  // nothing has moved since the first
}

TEST_CASE("fragments are counted on request, in a frame that is not timed", "[cost]") {
  Studio studio;
  studio.painter->paint(small_picture());
  CHECK_FALSE(studio.painter->cost().gl.fragments);
  studio.painter->count_fragments(true);
  studio.painter->paint(small_picture());
  const auto fragments = studio.painter->cost().gl.fragments;
  REQUIRE(fragments);
  CHECK(*fragments > 0);
  CHECK(*fragments < 32 * 24);
  CHECK(studio.painter->cost().groups.at(0).fragments == *fragments);
  const int before = studio.step.draws;
  studio.painter->time_frames(5);
  studio.painter->paint(small_picture());
  CHECK(studio.step.draws == before + 2 + 5 + 1);
  CHECK(studio.painter->cost().gl.fragments == fragments);
  CHECK(studio.painter->cost().frames->count == 5);
}

TEST_CASE("every count is in the table and, with the same name, in the JSON", "[cost]") {
  DrawingCost cost;
  cost.gl.triangles = 1234567;
  cost.scene.lights = 64;
  const nlohmann::json plain = nlohmann::json::parse(cost_as_json(cost));
  CHECK(plain["counts"]["triangles"] == 1234567);
  CHECK(plain["counts"]["lights"] == 64);
  CHECK_FALSE(plain.contains("frames"));
  for (const char* name : {"passes", "draws", "triangles", "vertices", "variants", "attributes", "texture_sources",
                           "target_bytes", "texture_bytes", "program_switches", "lights"})
    CHECK(plain["counts"].contains(name));

  cost.frames = {.count = 3, .median_s = 0.0125, .least_s = 0.01, .most_s = 0.02};
  const nlohmann::json timed = nlohmann::json::parse(cost_as_json(cost));
  CHECK(timed["frames"]["count"] == 3);
  CHECK(timed["frames"]["median_s"] == 0.0125);

  const std::string text = cost_as_text(cost);
  CHECK(mentions(text, {"1234567", "12.500", "milliseconds", "3 frames"}));
  std::istringstream lines(text);
  std::size_t rows = 0;
  for (std::string line; std::getline(lines, line); ++rows) CHECK(line.size() <= 100);  // fits a terminal
  CHECK(rows == cost_rows(cost).size() + 1);
}

TEST_CASE("groups are an indented list, with the same names in the JSON", "[cost]") {
  DrawingCost cost;
  const nlohmann::json none = nlohmann::json::parse(cost_as_json(cost));
  CHECK(none["groups"] == nlohmann::json::array());

  cost.groups = {{.depth = 0, .name = "frame", .passes = 3, .draws = 40, .triangles = 5000, .fragments = 250000},
                 {.depth = 1, .name = "shadow maps", .passes = 2, .draws = 30, .triangles = 4000},
                 {.depth = 2, .name = "map of light 0 (sun)", .passes = 1, .draws = 12, .triangles = 1500},
                 {.depth = 1, .name = "lamp\n\x1b[31m\xff", .passes = 0, .draws = 0, .triangles = 0},
                 {.depth = 99, .name = std::string(1000, 'x'), .passes = 0, .draws = 0, .triangles = 999999999999}};
  const std::string text = cost_as_text(cost);
  const std::string list = text.substr(text.find("\ngroup ") + 1);
  CHECK(
      list ==
      "group                                                  passes   draws    triangles    fragments\n"
      "frame                                                       3      40         5000       250000\n"
      "  shadow maps                                               2      30         4000            0\n"
      "    map of light 0 (sun)                                    1      12         1500            0\n"
      "  lamp\uFFFD\uFFFD[31m\uFFFD                                               0       0            0            0\n"
      "                xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx...       0       0 999999999999            0\n");

  const nlohmann::json json = nlohmann::json::parse(cost_as_json(cost));
  REQUIRE(json["groups"].size() == 5);
  CHECK(json["groups"][2] == nlohmann::json{{"depth", 2},
                                            {"name", "map of light 0 (sun)"},
                                            {"passes", 1},
                                            {"draws", 12},
                                            {"triangles", 1500},
                                            {"fragments", 0}});
  CHECK(json["groups"][3]["name"] == "lamp\uFFFD\uFFFD[31m\uFFFD");
}

TEST_CASE("the judge can read the counts of the maximum number of groups with long names", "[cost]") {
  constexpr std::int64_t many = 99'999'999;
  DrawingCost cost;
  cost.gl.triangles = 7;
  cost.groups.assign(256,
                     {.depth = 99, .name = std::string(1000, 'x'), .passes = 999, .draws = many, .triangles = many});
  const TemporaryFolder folder("atelier-cost-test");
  write_file(folder.path() / "a.stats", cost_as_json(cost));
  CHECK(read_counts(folder.held(), "a.stats").at("triangles") == 7);
}

TEST_CASE("the cost of each picture case is written beside its picture on request", "[cost]") {
  const std::string_view job = R"({"cases": [
    {"name": "box", "scene": "box", "size": [8, 8]}, {"name": "ring", "scene": "ring", "size": [8, 8]},
    {"name": "nowhere", "scene": "hall", "size": [8, 8]}, {"name": "values", "probe": "twice", "inputs": [{"x": 1}]}]})";
  Studio studio;
  write_file(studio.folder.path() / "job.json", job);
  const auto out = studio.folder.path() / "out";
  answer_cases(*studio.painter, studio.folder.path() / "job.json", out, {});
  CHECK_FALSE(std::filesystem::exists(out / "box.stats"));

  answer_cases(*studio.painter, studio.folder.path() / "job.json", out, {}, true);
  const auto triangles = [&](const char* name) {
    return nlohmann::json::parse(read_file(out / name))["counts"]["triangles"].get<int>();
  };
  CHECK(triangles("box.stats") == 12);
  CHECK(triangles("ring.stats") == 48 * 32 * 2);
  CHECK_FALSE(std::filesystem::exists(out / "nowhere.stats"));
  CHECK_FALSE(std::filesystem::exists(out / "values.stats"));
}
