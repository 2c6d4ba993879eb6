// Results as text, and the allowed differences between machines.
#include "measure/tables.hpp"

#include <nlohmann/json.hpp>
#include <sstream>

#include "catch.hpp"
#include "measure/charts.hpp"
#include "measure/page.hpp"
#include "results.hpp"

namespace atelier::measure {
namespace {

StepMeasured small_table() {
  StepMeasured measured{.step = "01-transforms", .environment = {{"cpu", "a <fast> one"}}};
  measured.sweeps = {sample_sweep()};
  measured.fronts = {sample_front()};
  return measured;
}

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> all;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) all.push_back(line);
  return all;
}

std::string replaced(std::string text, const std::string& part, const std::string& by) {
  text.replace(text.find(part), part.size(), by);
  return text;
}

}  // namespace

TEST_CASE("CSV has a line for each point and a column for each count") {
  const auto rows = lines(as_csv(small_table()));
  REQUIRE(rows.size() == 1 + 16 + 4);
  CHECK(rows[0] == "sweep,curve,value,metric,error,rmse,flip,median_s,least_s,most_s,draws,triangles");
  CHECK(rows[2] == "wall,fine,4,rmse,0.25,0.125,,0.004,0.0036,0.008,3,8");
  CHECK(rows[17] == "all,,a,flip,1,,,0.001,0.001,0.001,,");
}

TEST_CASE("a field that holds a comma or a quote is quoted") {
  StepMeasured measured = small_table();
  measured.sweeps[0].points[0].value = "a, \"b\"";
  CHECK(lines(as_csv(measured))[1].starts_with("wall,fine,\"a, \"\"b\"\"\",rmse,"));
}

TEST_CASE("JSON has fits, findings, fronts and knees") {
  StepMeasured measured = small_table();
  measured.sweeps[0].plan.expect = {{.curve = "fine", .number = -2, .tolerance = 0.1, .reason = "r"}};
  const auto json = nlohmann::json::parse(as_json(measured));
  const auto& sweep = json["sweeps"][0];
  REQUIRE(sweep["fits"].size() == 1);  // the flat curve lies on its own floor
  CHECK(sweep["fits"][0]["slope"].get<double>() == Approx(-2));
  CHECK(sweep["noise_floor"].get<double>() == Approx(4.0 / 65536));
  CHECK(sweep["findings"][0]["met"] == true);
  CHECK(sweep["points"].size() == 16);
  CHECK(sweep["points"][0]["flip"].is_null());
  CHECK(json["fronts"][0]["pareto_front"] == nlohmann::json({"a", "b", "d"}));
  CHECK(json["fronts"][0]["knee"] == "b");
}

TEST_CASE("a front without times has no ranking") {
  FrontResult front = sample_front();
  front.points[1].cost.times.reset();
  CHECK(rank(front).front.empty());
  CHECK_FALSE(rank(front).knee);
  CHECK_FALSE(chart_of_front(front));
}

TEST_CASE("stored numbers may differ only as much as between processors") {
  const std::string stored = errors_as_csv(sample_sweep());
  CHECK(lines(stored)[0] == "kind,pieces,rmse");
  CHECK(lines(stored)[2] == "fine,4,0.25");
  struct Row {
    const char* name;
    std::string ours;
    const char* words;
  };
  const std::vector<Row> rows = {
      {"the same", stored, ""},
      {"off by a tenth", replaced(stored, "fine,4,0.25", "fine,4,0.27"), ""},
      {"near the floor", replaced(stored, "fine,256,6.10352e-05", "fine,256,0.009"), ""},
      {"off by a fifth", replaced(stored, "fine,4,0.25", "fine,4,0.3"), "fine,4: 0.3, but 0.25 is stored"},
      {"no number", replaced(stored, "fine,4,0.25", "fine,4,nan"), "fine,4"},
      {"another value", replaced(stored, "fine,4,", "fine,5,"), "fine,5, but one for fine,4"},
      {"a line less", stored.substr(0, stored.rfind("coarse")), "15 lines, but 16"},
      {"another metric", replaced(stored, "rmse", "flip"), "columns"},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    const std::string words = difference(row.ours, stored);
    INFO(words);
    CHECK(words.empty() == std::string_view(row.words).empty());
    CHECK(words.find(row.words) != std::string::npos);
  }
}

TEST_CASE("charts show the measurements, and times only on request") {
  SweepResult sweep = sample_sweep();
  sweep.plan.expect = {{.curve = "fine", .number = -2, .tolerance = 0.1, .reason = "r"}};
  const Plot errors = chart_of_errors(sweep);
  REQUIRE(errors.curves.size() == 3);
  CHECK(errors.curves[0].title == "kind fine");
  CHECK(errors.curves[0].points[1] == glm::dvec2(4, 0.25));
  CHECK(errors.curves[2].title == "slope -2.00");
  CHECK(errors.x.scale == Scale::logarithmic);
  CHECK(errors.levels.size() == 1);
  const auto times = chart_of_times(sweep);
  REQUIRE(times);
  CHECK(times->curves[0].points[1].x == Approx(4));  // milliseconds
  CHECK(times->curves[0].spread[1].y == Approx(8));
  for (Point& point : sweep.points) point.cost.times.reset();
  CHECK_FALSE(chart_of_times(sweep));
  const auto front = chart_of_front(sample_front());
  REQUIRE(front);
  CHECK(front->curves[1].points.size() == 3);
  REQUIRE(front->marks.size() == 1);
  CHECK(front->marks[0].at.x == Approx(2));
}

TEST_CASE("a count stands under its own name, and times against the swept value") {
  StepMeasured measured = small_table();
  SweepResult& sweep = measured.sweeps[0];
  sweep.plan.count = "triangles";
  for (Point& point : sweep.points) {
    point.error = point.cost.counts.at("triangles");
    point.rmse.reset();
  }
  CHECK(lines(as_csv(measured))[2] == "wall,fine,4,triangles,8,,,0.004,0.0036,0.008,3,8");
  CHECK(lines(errors_as_csv(sweep))[0] == "kind,pieces,triangles");
  const auto json = nlohmann::json::parse(as_json(measured));
  CHECK(json["sweeps"][0]["metric"] == "triangles");
  CHECK(json["sweeps"][0]["noise_floor"] == 0);
  const auto times = chart_of_times(sweep);
  REQUIRE(times);
  CHECK(times->curves[0].points[1].x == 4);
  CHECK(times->curves[0].points[1].y == Approx(4));  // milliseconds
  CHECK(times->curves[0].spread.empty());
}

TEST_CASE("a count that the program does not have is refused with the nearest one") {
  const Cost cost{.counts = {{"draws", 3}, {"vertices", 36}}};
  CHECK(count_of(cost, "draws", "measure.json") == 3);
  CHECK(test::mentions(test::error_of([&] { count_of(cost, "vertexes", "measure.json"); }),
                       {"measure.json", "'vertexes'", "did you mean 'vertices'"}));
}

TEST_CASE("the page is self-contained, and escapes text") {
  if (!can_plot()) SKIP_TEST("gnuplot is not installed");
  StepMeasured measured = small_table();
  measured.sweeps[0].plan.expect = {{.curve = "fine", .number = -1, .tolerance = 0.1, .reason = "<b>why</b>"}};
  const std::string html = page(measured);
  CHECK(test::mentions(html, {"data:image/svg+xml;base64,", "default-src 'none'", "Recommended default: <b>b</b>",
                              "not as expected", "&lt;b&gt;why&lt;/b&gt;", "a &lt;fast&gt; one"}));
  CHECK(html.find("<b>why") == std::string::npos);
  CHECK(html.find("http://") == std::string::npos);
  CHECK(html.find("<script") == std::string::npos);
}

}  // namespace atelier::measure
