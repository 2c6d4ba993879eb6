// measure.json: reading, refused input, and whether it fits its program.
#include "measure/plan.hpp"

#include <functional>
#include <nlohmann/json.hpp>

#include "catch.hpp"

namespace atelier::measure {
namespace {

using nlohmann::json;
using test::error_of;
using test::mentions;

json sweep() {
  return {{"name", "wall"},
          {"title", "How round"},
          {"scene", "hall"},
          {"size", {64, 48}},
          {"output", "position"},
          {"settings", {{"draw.wireframe", false}}},
          {"setting", "hall.segments"},
          {"values", {4, 8, 16}},
          {"curves_by", "depth.format"},
          {"curves", {"16", "24"}},
          {"truth", {{"by", "oracle"}, {"samples", 4}, {"settings", {{"hall.segments", 4096}}}}},
          {"metric", "distance"},
          {"x", "pieces"},
          {"y", "error, m"},
          {"handout", true},
          {"expect",
           {{{"slope", -2}, {"tolerance", 0.2}, {"range", {4, 16}}, {"curve", "24"}, {"reason", "the sagitta"}},
            {{"order", {16, 8, 4}}, {"reason", "finer is better"}},
            {{"at_most", 1}, {"reason", "the hall is no larger"}},
            {{"at", 8}, {"is", 0.4}, {"tolerance", 0.1}, {"reason", "by hand"}}}}};
}

json front() {
  return {{"name", "all"},
          {"title", "All of it"},
          {"scene", "hall"},
          {"grid", {{"hall.segments", {4, 8}}, {"depth.format", {"16", "24"}}}}};
}

json whole_plan() {
  return {{"schema", 1},
          {"step", "01-transforms"},
          {"sweeps", {sweep()}},
          {"fronts", {front()}},
          {"not_measured", {{"draw.wireframe", "nothing is approximated"}}}};
}

Plan parsed(const json& text) {
  return parse_plan(text.dump(), "measure.json");
}

std::vector<SettingSpec> settings() {
  return {{.name = "hall.segments", .fallback = 64, .low = 3, .high = 4096},
          {.name = "depth.format", .fallback = std::string("24"), .choices = {"16", "24"}},
          {.name = "draw.wireframe", .fallback = false}};
}

/// The program's settings with a colour, and a plan that sweeps it.
std::vector<SettingSpec> settings_with_sky() {
  std::vector<SettingSpec> all = settings();
  all.push_back({.name = "sky", .fallback = Colour(0), .low = 0, .high = 1});
  return all;
}

json plan_of_sky() {
  json d = whole_plan();
  json& sky = d["sweeps"].emplace_back(sweep());
  sky["name"] = "sky";
  sky["setting"] = "sky";
  sky["values"] = {{0, 0, 0}, {0.2, 0.5, 1}, "#ffffff"};
  sky["expect"] = {{{"order", {{1, 1, 1}, "#000000"}}, {"reason", "r"}},
                   {{"at", {0.2, 0.5, 1}}, {"is", 0.4}, {"tolerance", 0.1}, {"reason", "by hand"}}};
  d["fronts"][0]["grid"]["sky"] = {{0, 0, 0}, "#ff0000"};
  return d;
}

struct Row {
  const char* name;
  std::function<void(json&)> spoil;
  std::initializer_list<std::string_view> words;
};

}  // namespace

TEST_CASE("a plan is read") {
  const Plan plan = parsed(whole_plan());
  CHECK(plan.step == "01-transforms");
  REQUIRE(plan.sweeps.size() == 1);
  const Sweep& read = plan.sweeps[0];
  CHECK(read.name == "wall");
  CHECK(read.ask.scene == "hall");
  CHECK(read.ask.size == glm::ivec2(64, 48));
  CHECK(read.ask.output == "position");
  CHECK(read.ask.settings.at("draw.wireframe") == SettingValue(false));
  CHECK(read.setting == "hall.segments");
  CHECK(read.values == std::vector<SettingValue>{4, 8, 16});
  CHECK(read.curves == std::vector<SettingValue>{std::string("16"), std::string("24")});
  CHECK(read.truth.by == Truth::By::oracle);
  CHECK(read.truth.samples == 4);
  CHECK(read.truth.settings.at("hall.segments") == SettingValue(4096));
  CHECK(read.metric == Metric::distance);
  CHECK(read.handout);
  CHECK_FALSE(read.linear);
  REQUIRE(read.expect.size() == 4);
  CHECK(read.expect[0].kind == Expectation::Kind::slope);
  CHECK(read.expect[0].number == -2);
  CHECK(read.expect[0].range == glm::dvec2(4, 16));
  CHECK(read.expect[0].curve == "24");
  CHECK(read.expect[1].values == std::vector<std::string>{"16", "8", "4"});
  CHECK(read.expect[2].kind == Expectation::Kind::at_most);
  CHECK(read.expect[3].values == std::vector<std::string>{"8"});
  CHECK(read.expect[3].number == 0.4);
  REQUIRE(plan.fronts.size() == 1);
  CHECK(plan.fronts[0].grid.size() == 2);
  CHECK(plan.fronts[0].metric == Metric::flip);
  CHECK(plan.not_measured.at("draw.wireframe") == "nothing is approximated");
}

TEST_CASE("colours are swept like choices, by light or by codes") {
  const Plan plan = parsed(plan_of_sky());
  const Sweep& sky = plan.sweeps[1];
  CHECK(sky.values == std::vector<SettingValue>{Colour(0), Colour(0.2, 0.5, 1), Colour(1)});
  CHECK(sky.expect[0].values == std::vector<std::string>{"1,1,1", "0,0,0"});
  CHECK(sky.expect[1].values == std::vector<std::string>{"0.2,0.5,1"});
  CHECK(error_of([&] { check_against(plan, settings_with_sky(), {"colour", "position"}); }) == "");

  const Row rows[] = {
      {"a colour twice",
       [](json& d) {
         d["sweeps"][1]["values"] = {{1, 1, 1}, "#ffffff"};
       },
       {"sweep 'sky'", "once"}},
      {"no colour",
       [](json& d) {
         d["sweeps"][1]["values"] = {"#fff", "#ffffff"};
       },
       {"sweep 'sky'", "#fff", "#rrggbb"}},
      {"numbers in place of colours",
       [](json& d) {
         d["sweeps"][1]["values"] = {0, 0.5, 1};
       },
       {"sweep 'sky'", "setting 'sky': 0 is not allowed", "R,G,B"}},
      {"a colour out of range",
       [](json& d) {
         d["fronts"][0]["grid"]["sky"] = json::array({{0, 0, 1.5}});
       },
       {"front 'all'", "0,0,1.5", "0..1"}},
      {"a colour that is not swept",
       [](json& d) { d["sweeps"][1]["expect"][1]["at"] = "#0000ff"; },
       {"sweep 'sky'", "'0,0,1' is not among"}},
      {"a colour without values",
       [](json& d) { d["sweeps"][1].erase("values"); },
       {"sweep 'sky'", "sky is a colour", "must name its values"}},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    json d = plan_of_sky();
    row.spoil(d);
    const std::string error = error_of([&] { check_against(parsed(d), settings_with_sky(), {"colour", "position"}); });
    INFO(error);
    CHECK(mentions(error, row.words));
  }
}

TEST_CASE("a truth may be a number, or the program itself") {
  json d = whole_plan();
  d["sweeps"][0]["truth"] = 1;
  d["sweeps"][0]["metric"] = "mean";
  CHECK(parsed(d).sweeps[0].truth.by == Truth::By::value);
  d["sweeps"][0]["truth"] = {{"by", "program"}, {"settings", {{"hall.segments", 4096}}}};
  d["sweeps"][0]["metric"] = "flip";
  CHECK(parsed(d).sweeps[0].truth.by == Truth::By::program);
}

TEST_CASE("a count is measured without a truth") {
  json d = whole_plan();
  d["sweeps"][0]["count"] = "draws";
  d["sweeps"][0].erase("truth");
  d["sweeps"][0].erase("metric");
  const Sweep read = parsed(d).sweeps[0];
  CHECK(read.count == "draws");
  CHECK(read.truth.by == Truth::By::none);
  CHECK(parsed(whole_plan()).sweeps[0].count.empty());
}

TEST_CASE("an invalid plan is refused with its place") {
  const auto in_sweep = [](const char* member, json value) { return [=](json& d) { d["sweeps"][0][member] = value; }; };
  const auto in_expect = [](json value) { return [=](json& d) { d["sweeps"][0]["expect"][0] = value; }; };
  const Row rows[] = {
      {"another schema", [](json& d) { d["schema"] = 2; }, {"measure.json: schema"}},
      {"an unknown member", [](json& d) { d["sweep"] = 1; }, {"sweep", "sweeps"}},
      {"an unknown member of a sweep", in_sweep("colour", 1), {"sweep", "colour"}},
      {"no scene", [](json& d) { d["sweeps"][0].erase("scene"); }, {"sweep 'wall'", "scene"}},
      {"a size of nothing", in_sweep("size", {0, 4}), {"wall", "size"}},
      {"no setting", [](json& d) { d["sweeps"][0].erase("setting"); }, {"wall", "setting"}},
      {"a value twice", in_sweep("values", {4, 4}), {"wall", "values", "once"}},
      {"no value", in_sweep("values", json::array()), {"wall", "values"}},
      {"curves alone", [](json& d) { d["sweeps"][0].erase("curves_by"); }, {"wall", "curves_by and curves"}},
      {"curves by the same setting", in_sweep("curves_by", "hall.segments"), {"wall", "curves_by", "another setting"}},
      {"a swept setting that stays", in_sweep("settings", {{"hall.segments", 5}}), {"wall", "hall.segments", "swept"}},
      {"an unknown metric", in_sweep("metric", "ssim"), {"wall", "metric", "ssim", "rmse"}},
      {"a number for a truth without a mean", in_sweep("truth", 1), {"wall", "metric", "distance", "mean"}},
      {"a mean without a number", in_sweep("metric", "mean"), {"wall", "metric", "mean"}},
      {"a truth by nobody", in_sweep("truth", {{"by", "judge"}}), {"wall", "truth: by", "judge", "oracle"}},
      {"samples of the program", in_sweep("truth", {{"by", "program"}, {"samples", 2}}), {"wall", "samples"}},
      {"too many samples", in_sweep("truth", {{"by", "oracle"}, {"samples", 65}}), {"wall", "samples", "65"}},
      {"a count of a truth",
       [](json& d) {
         d["sweeps"][0]["count"] = "draws";
         d["sweeps"][0].erase("metric");
       },
       {"wall", "truth", "beside count"}},
      {"a count in a metric",
       [](json& d) {
         d["sweeps"][0]["count"] = "draws";
         d["sweeps"][0].erase("truth");
       },
       {"wall", "metric", "beside count"}},
      {"a count that is no name",
       [](json& d) {
         d["sweeps"][0]["count"] = "Draw calls";
         d["sweeps"][0].erase("truth");
         d["sweeps"][0].erase("metric");
       },
       {"wall", "count", "Draw calls"}},
      {"no label", [](json& d) { d["sweeps"][0].erase("x"); }, {"wall", "x"}},
      {"a name twice", [](json& d) { d["sweeps"].push_back(sweep()); }, {"wall", "twice"}},
      {"a front of the same name", [](json& d) { d["fronts"][0]["name"] = "wall"; }, {"front", "wall", "twice"}},
      {"no reason", in_expect({{"slope", -2}, {"tolerance", 0.2}}), {"wall", "expect", "reason"}},
      {"no tolerance", in_expect({{"slope", -2}, {"reason", "r"}}), {"wall", "expect", "tolerance"}},
      {"two kinds", in_expect({{"slope", -2}, {"at_most", 1}, {"reason", "r"}}), {"wall", "exactly one"}},
      {"no kind", in_expect({{"reason", "r"}}), {"wall", "exactly one"}},
      {"a range of an order", in_expect({{"order", {4, 8}}, {"range", {1, 2}}, {"reason", "r"}}), {"wall", "range"}},
      {"a range from zero",
       in_expect({{"slope", 1}, {"tolerance", 1}, {"range", {0, 2}}, {"reason", "r"}}),
       {"wall", "range", "0 < from"}},
      {"an order of one", in_expect({{"order", {4}}, {"reason", "r"}}), {"wall", "order", "two values"}},
      {"a grid too large",
       [](json& d) {
         json many = json::array();
         for (int i = 0; i < 20; ++i) many.push_back(i);
         d["fronts"][0]["grid"] = {{"a", many}, {"b", many}};
       },
       {"front 'all'", "400", "256"}},
      {"an empty grid", [](json& d) { d["fronts"][0]["grid"] = json::object(); }, {"front 'all'", "grid"}},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    json d = whole_plan();
    row.spoil(d);
    const std::string error = error_of([&] { parsed(d); });
    INFO(error);
    CHECK(mentions(error, row.words));
  }
}

TEST_CASE("a plan must fit its program, and cover all its settings") {
  const std::vector<std::string> outputs = {"colour", "position"};
  CHECK(error_of([&] { check_against(parsed(whole_plan()), settings(), outputs); }) == "");
  const Row rows[] = {
      {"an unknown setting",
       [](json& d) { d["sweeps"][0]["setting"] = "hall.segment"; },
       {"sweep 'wall'", "hall.segment", "did you mean 'hall.segments'"}},
      {"a value out of range",
       [](json& d) {
         d["sweeps"][0]["values"] = {2, 8};
       },
       {"sweep 'wall'", "2", "3..4096"}},
      {"a choice that is none", [](json& d) { d["sweeps"][0]["curves"] = {"64"}; }, {"sweep 'wall'", "64", "16, 24"}},
      {"a value of a front", [](json& d) { d["fronts"][0]["grid"]["hall.segments"] = {1}; }, {"front 'all'", "1"}},
      {"a setting of a truth",
       [](json& d) {
         d["sweeps"][0]["truth"]["settings"] = {{"hall.segments", 9999}};
       },
       {"sweep 'wall'", "truth", "9999"}},
      {"an unknown output",
       [](json& d) { d["sweeps"][0]["output"] = "stencil"; },
       {"sweep 'wall'", "stencil", "colour, position"}},
      {"a curve that is not drawn",
       [](json& d) { d["sweeps"][0]["expect"][0]["curve"] = "32f"; },
       {"sweep 'wall'", "no curve '32f'"}},
      {"a value that is not swept",
       [](json& d) { d["sweeps"][0]["expect"][3]["at"] = 5; },
       {"sweep 'wall'", "'5' is not among"}},
      {"a setting forgotten", [](json& d) { d.erase("not_measured"); }, {"draw.wireframe", "not_measured"}},
      {"measured, and said not to be",
       [](json& d) { d["not_measured"]["depth.format"] = "why"; },
       {"depth.format", "measured by a sweep or a front"}},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    json d = whole_plan();
    row.spoil(d);
    const std::string error = error_of([&] { check_against(parsed(d), settings(), outputs); });
    INFO(error);
    CHECK(mentions(error, row.words));
  }
}

TEST_CASE("without values, the whole range is swept") {
  struct Default {
    const char* name;
    SettingSpec spec;
    std::vector<SettingValue> values;
  };
  const std::vector<Default> rows = {
      {"on and off", {.name = "a", .fallback = true}, {false, true}},
      {"choices",
       {.name = "a", .fallback = std::string("x"), .choices = {"x", "y"}},
       {std::string("x"), std::string("y")}},
      {"whole, by doubling", {.name = "a", .fallback = 1, .low = 1, .high = 256}, {1, 2, 4, 8, 16, 32, 64, 128, 256}},
      {"whole, from zero", {.name = "a", .fallback = 1, .low = 0, .high = 4}, {0, 1, 2, 3, 4}},
      {"real, by tens",
       {.name = "a", .fallback = 1.0, .low = 1e-4, .high = 1e4},
       {1e-4, 1e-3, 1e-2, 1e-1, 1e0, 1e1, 1e2, 1e3, 1e4}},
      {"one value", {.name = "a", .fallback = 0, .low = 0, .high = 0}, {0}},
      {"a colour", {.name = "a", .fallback = Colour(0), .low = 0, .high = 1}, {}},
  };
  for (const Default& row : rows) {
    INFO(row.name);
    const auto values = default_values(row.spec);
    REQUIRE(values.size() == row.values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (const double* real = std::get_if<double>(&row.values[i]))
        CHECK(std::get<double>(values[i]) == Approx(*real));
      else
        CHECK(values[i] == row.values[i]);
    }
  }
}

}  // namespace atelier::measure
