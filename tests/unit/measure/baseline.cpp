// baseline.json: reading, refused input, and when a row reaches its aim.
#include "measure/baseline.hpp"

#include <functional>
#include <nlohmann/json.hpp>

#include "catch.hpp"

namespace atelier::measure {
namespace {

using nlohmann::json;
using test::error_of;
using test::mentions;

json comparison() {
  return {
      {"baseline", "shadow-demo"},
      {"scene", "cubes"},
      {"size", {80, 60}},
      {"settings", {{"scene.casters", "all"}, {"shadow.pcf", 5}}},
      {"output", "shadow_factor"},
      {"metric", "wrong"},
      {"samples", 4},
      {"rows",
       {{{"name", "the same settings"}, {"settings", {{"shadow.pcf", 3}, {"sky", {0.2, 0.5, 1}}}}, {"aim", 1}},
        {{"name", "fitted"}, {"aim", 1.5}, {"no_larger_error", true}, {"baseline_settings", {{"frame.format", "8"}}}},
        {{"name", "as it is"}}}}};
}

}  // namespace

TEST_CASE("a comparison with a baseline is read") {
  const BaselinePlan plan = parse_baseline_plan(comparison().dump(), "baseline.json");
  CHECK(plan.program == "shadow-demo");
  CHECK(plan.scene == "cubes");
  CHECK(plan.size == glm::ivec2(80, 60));
  CHECK(plan.output == "shadow_factor");
  CHECK(plan.metric == ErrorMetric::wrong);
  CHECK(plan.settings.size() == 2);
  CHECK(plan.samples == 4);
  REQUIRE(plan.rows.size() == 3);
  CHECK(plan.rows[0].name == "the same settings");
  CHECK(plan.rows[0].settings.at("shadow.pcf") == SettingValue(3));
  CHECK(plan.rows[0].settings.at("sky") == SettingValue(Colour(0.2, 0.5, 1)));
  CHECK(plan.rows[0].aim == 1);
  CHECK_FALSE(plan.rows[0].no_larger_error);
  CHECK(plan.rows[0].baseline_settings.empty());
  CHECK(plan.rows[0].settings.at("scene.casters") == SettingValue(std::string("all")));
  CHECK(plan.rows[1].settings == plan.settings);
  CHECK(plan.rows[1].baseline_settings.at("frame.format") == SettingValue(std::string("8")));
  CHECK(plan.rows[1].aim == 1.5);
  CHECK(plan.rows[1].no_larger_error);
  CHECK(plan.rows[2].aim == 0);
}

TEST_CASE("an invalid comparison is refused with its place") {
  struct Row {
    const char* name;
    std::function<void(json&)> spoil;
    std::initializer_list<std::string_view> words;
  };
  const Row rows[] = {
      {"an unknown member", [](json& d) { d["scenes"] = 1; }, {"baseline.json", "scenes", "scene"}},
      {"no program", [](json& d) { d.erase("baseline"); }, {"baseline.json", "baseline"}},
      {"a path for a program", [](json& d) { d["baseline"] = "../sh"; }, {"baseline.json: baseline", "../sh"}},
      {"a size of nothing",
       [](json& d) {
         d["size"] = {0, 60};
       },
       {"baseline.json", "size"}},
      {"a size of one number", [](json& d) { d["size"] = 60; }, {"baseline.json", "size"}},
      {"a metric that is none", [](json& d) { d["metric"] = "wron"; }, {"baseline.json: metric", "wron", "rmse"}},
      {"a metric of one picture", [](json& d) { d["metric"] = "mean"; }, {"baseline.json: metric", "mean"}},
      {"too many samples", [](json& d) { d["samples"] = 65; }, {"baseline.json: samples", "65"}},
      {"no row", [](json& d) { d["rows"] = json::array(); }, {"baseline.json: rows", "at least one"}},
      {"a row without a name", [](json& d) { d["rows"][1].erase("name"); }, {"row 2", "name"}},
      {"an unknown member of a row", [](json& d) { d["rows"][0]["goal"] = 2; }, {"row 1", "goal"}},
      {"settings of the baseline that are none",
       [](json& d) { d["rows"][0]["baseline_settings"] = 3; },
       {"row 1", "baseline_settings"}},
      {"settings that are none", [](json& d) { d["rows"][0]["settings"] = 3; }, {"row 1", "settings"}},
      {"a colour of two numbers",
       [](json& d) {
         d["rows"][0]["settings"] = {{"sky", json::array({0.2, 0.5})}};
       },
       {"baseline.json: row 1: settings: sky", "[0.2,0.5]", "3 finite numbers"}},
      {"an aim of nothing", [](json& d) { d["rows"][0]["aim"] = 0; }, {"row 1: aim", "0"}},
      {"a word for a flag", [](json& d) { d["rows"][1]["no_larger_error"] = "yes"; }, {"row 2", "no_larger_error"}},
  };
  for (const Row& row : rows) {
    json spoiled = comparison();
    row.spoil(spoiled);
    const std::string words = error_of([&] { parse_baseline_plan(spoiled.dump(), "baseline.json"); });
    INFO(row.name << ": " << words);
    CHECK(mentions(words, row.words));
  }
}

TEST_CASE("a row passes if it is fast enough and, on request, no less accurate") {
  const Compared baseline{.rmse = 0.01, .error = 0.02};
  struct Row {
    const char* name;
    bool no_larger_error;
    Compared compared;
    bool reached;
  };
  const Row rows[] = {
      {"too slow", false, {.ratio = 1.49, .rmse = 0, .error = 0}, false},
      {"fast enough", false, {.ratio = 1.5, .rmse = 1, .error = 1}, true},
      {"fast, and as true", true, {.ratio = 1.5, .rmse = 0.01, .error = 0.02}, true},
      {"fast, and as true but for rounding", true, {.ratio = 1.5, .rmse = 0.01005, .error = 0.0201}, true},
      {"fast, but of wrong colours", true, {.ratio = 9, .rmse = 0.0102, .error = 0}, false},
      {"fast, but of wrong shadows", true, {.ratio = 9, .rmse = 0, .error = 0.0205}, false},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    CHECK(reaches_aim({.aim = 1.5, .no_larger_error = row.no_larger_error}, row.compared, baseline) == row.reached);
  }
}

}  // namespace atelier::measure
