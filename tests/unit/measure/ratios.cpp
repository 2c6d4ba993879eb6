// ratios.json: reading, refused input, and when a row holds.
#include "measure/ratios.hpp"

#include <functional>
#include <nlohmann/json.hpp>

#include "catch.hpp"

namespace atelier::measure {
namespace {

using nlohmann::json;
using test::error_of;
using test::mentions;

json ratios() {
  return {{"defaults", {{"scene", "corridor"}, {"size", {80, 60}}, {"settings", {{"portals.smallest", 2}}}}},
          {"counts", {"draws", "vertices"}},
          {"rows",
           {{{"name", "two doors"},
             {"picture", {{"settings", {{"portals.depth", 2}, {"portals.clip", "oblique"}}}}},
             {"beside", {{"settings", {{"portals.depth", 0}}}}},
             {"at_most", 1.6}},
            {{"name", "a door that fills the picture"},
             {"picture", {{"scene", "rooms"}, {"camera", {{"eye", {0, 1, 2}}, {"near", 0.5}}}}},
             {"beside", {{"camera", {{"eye", {41, 1, 2}}}}}},
             {"without", {{"scene", "empty"}}},
             {"alike", 0.01}}}}};
}

RatioPlan plan_of(const json& document) {
  return parse_ratio_plan(document.dump(), "ratios.json");
}

}  // namespace

TEST_CASE("pictures take what they lack from the defaults, and the second one from the first") {
  const RatioPlan plan = plan_of(ratios());
  CHECK(plan.counts == std::vector<std::string>{"draws", "vertices"});
  REQUIRE(plan.rows.size() == 2);
  const RatioRow& doors = plan.rows[0];
  CHECK(doors.name == "two doors");
  CHECK(doors.picture.scene == "corridor");
  CHECK(doors.picture.size == glm::ivec2(80, 60));
  CHECK(doors.picture.settings.at("portals.depth") == SettingValue(2));
  CHECK(doors.picture.settings.at("portals.smallest") == SettingValue(2));
  CHECK(doors.beside.scene == "corridor");
  CHECK(doors.beside.settings.at("portals.depth") == SettingValue(0));
  CHECK(doors.beside.settings.at("portals.clip") == SettingValue(std::string("oblique")));
  CHECK(doors.beside.settings.at("portals.smallest") == SettingValue(2));
  CHECK(doors.at_most == 1.6);
  CHECK_FALSE(doors.alike);
  const RatioRow& filled = plan.rows[1];
  CHECK(filled.beside.scene == "rooms");
  CHECK(filled.beside.camera.eye == glm::dvec3(41, 1, 2));
  CHECK(filled.beside.camera.near == 0.5);
  CHECK(filled.picture.camera.eye == glm::dvec3(0, 1, 2));
  CHECK(filled.alike == 0.01);
  REQUIRE(filled.without);
  CHECK(filled.without->scene == "empty");
  CHECK(filled.without->camera.eye == glm::dvec3(0, 1, 2));
  CHECK_FALSE(doors.without);
  CHECK_FALSE(filled.at_most);
}

TEST_CASE("invalid ratios are refused with their place") {
  struct Row {
    const char* name;
    std::function<void(json&)> spoil;
    std::initializer_list<std::string_view> words;
  };
  const auto in_row = [](const char* member, json value) { return [=](json& d) { d["rows"][0][member] = value; }; };
  const Row rows[] = {
      {"an unknown member", [](json& d) { d["row"] = 1; }, {"ratios.json", "row", "rows"}},
      {"an unknown member of the defaults", [](json& d) { d["defaults"]["points"] = 3; }, {"defaults", "points"}},
      {"no counts", [](json& d) { d.erase("counts"); }, {"ratios.json", "counts"}},
      {"a count twice",
       [](json& d) {
         d["counts"] = {"draws", "draws"};
       },
       {"counts", "draws"}},
      {"no row", [](json& d) { d["rows"] = json::array(); }, {"rows", "at least one"}},
      {"an unknown member of a row", in_row("aim", 2), {"row 1", "aim"}},
      {"a row without a name", [](json& d) { d["rows"][1].erase("name"); }, {"row 2", "name"}},
      {"a row without a second picture", [](json& d) { d["rows"][1].erase("beside"); }, {"row 2", "beside"}},
      {"what only the judge reads", in_row("picture", {{"points", 3}}), {"row 1: picture", "points"}},
      {"a picture that is none", in_row("beside", 3), {"row 1: beside"}},
      {"a size of nothing", in_row("beside", {{"size", {0, 60}}}), {"row 1", "'beside'", "size"}},
      {"no scene", [](json& d) { d["defaults"].erase("scene"); }, {"row 1", "scene"}},
      {"a ratio of nothing", in_row("at_most", 0), {"row 1: at_most", "0"}},
      {"a negative difference", in_row("alike", -0.1), {"row 1: alike", "-0.1"}},
      {"different sizes that are alike",
       [](json& d) {
         d["rows"][1]["beside"]["size"] = {40, 30};
       },
       {"row 2: alike", "sizes or outputs"}},
      {"different outputs that are alike",
       [](json& d) { d["rows"][1]["beside"]["output"] = "depth"; },
       {"row 2: alike", "sizes or outputs"}},
  };
  for (const Row& row : rows) {
    json spoiled = ratios();
    row.spoil(spoiled);
    const std::string words = error_of([&] { plan_of(spoiled); });
    INFO(row.name << ": " << words);
    CHECK(mentions(words, row.words));
  }
}

TEST_CASE("a row holds if it is cheap enough and, on request, shows the same") {
  struct Row {
    const char* name;
    std::optional<double> at_most, alike;
    MeasuredRatio measured;
    bool held;
  };
  const Row rows[] = {
      {"nothing is asked", {}, {}, {.ratio = {.median = 9}}, true},
      {"cheap enough", 1.3, {}, {.ratio = {.median = 1.3, .least = 1, .most = 2}}, true},
      {"too dear", 1.3, {}, {.ratio = {.median = 1.31, .least = 1, .most = 2}}, false},
      {"cheap, and the same", 1.3, 0.01, {.ratio = {.median = 1}, .difference = 0.01}, true},
      {"cheap, but another picture", 1.3, 0.01, {.ratio = {.median = 1}, .difference = 0.011}, false},
      {"the same to the last bit", {}, 0, {.difference = 0}, true},
      {"not the same to the last bit", {}, 0, {.difference = 1e-9}, false},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    CHECK(holds({.at_most = row.at_most, .alike = row.alike}, row.measured) == row.held);
  }
}

TEST_CASE("the spread of rounds") {
  const Spread odd = spread_of({3, 1, 2}), even = spread_of({4, 1, 2, 3}), one = spread_of({5});
  CHECK(odd.median == 2);
  CHECK(odd.least == 1);
  CHECK(odd.most == 3);
  CHECK(even.median == 2.5);
  CHECK(one.median == 5);
  CHECK(one.least == one.most);
}

}  // namespace atelier::measure
