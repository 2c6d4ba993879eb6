// Baselines draw the same pictures as the steps, without which a comparison of times is meaningless; and the comparison
// is complete. No time is asserted on.
#include <filesystem>
#include <map>

#include "base/error.hpp"
#include "catch.hpp"
#include "cli/search_path.hpp"
#include "command.hpp"
#include "image/error.hpp"
#include "measure/baseline.hpp"

using namespace atelier;
using namespace atelier::test;

namespace {

struct Rivals {
  CourseStep step;
  measure::BaselinePlan plan;
  measure::Program ours, theirs;
};

std::vector<Rivals> rivals() {
  std::vector<Rivals> all;
  for (const CourseStep& step : course()) {
    if (!std::filesystem::exists(folders().baseline_file(step.name))) continue;
    Rivals found{.step = step, .plan = measure::read_baseline_plan(folders().baseline_file(step.name))};
    found.ours.file = folders().program(step.name);
    found.ours.implementations = search_path(folders(), step, code_of(folders(), Owner::solution), {});
    found.theirs = found.ours;
    found.theirs.file = folders().program(found.plan.program);
    all.push_back(std::move(found));
  }
  return all;
}

using SettingValues = std::map<std::string, SettingValue>;

Image drawn(const measure::Program& program, const Rivals& r, const std::string& output,
            const SettingValues& settings) {
  const Case picture{
      .name = "picture", .scene = r.plan.scene, .size = {200, 150}, .settings = settings, .output = output};
  return measure::draw(program, {picture}).front().picture;
}

/// Whether the output that is compared is the point where a ray meets a relief.
bool follows_relief(const Rivals& r) {
  return r.plan.metric == ErrorMetric::distance;
}

/// How far the output that a plan compares may differ.
struct Allowed {
  double alike = 0;  ///< between two programs that draw the same
  double error = 0;  ///< from the ground truth, with all settings of the plan
};

Allowed allowed_for(ErrorMetric metric) {
  switch (metric) {
    // Faces that turn away from the light are in each program's shadow as its bias has it, and dark in both: the demo
    // of the sun shows one from below, 1.5 % of the picture. The largest error is that of the demo, 1.6 %.
    case ErrorMetric::wrong:
      return {.alike = 0.02, .error = 0.05};
    // Alike: the same maps and frames, so only rounding, and the order of interpolation. Errors: three times those of
    // normals in 8 bits, 0.33; without a normal map it is 14.
    case ErrorMetric::degrees:
      return {.alike = 0.1, .error = 1};
    // Alike: other layers, so other points at the bricks' sides, a twentieth of the depth of 0.002. Errors: up to 0.03,
    // most of it from pixels along the wall's outline that one of the two discards; without the relief it is 0.14.
    case ErrorMetric::distance:
      return {.alike = 1e-4, .error = 0.05};
    default:
      throw Error("a baseline with a metric that no other has: say how large its differences may be");
  }
}

/// Of colours, from the ground truth: twice that of normal maps in 8 bits, 0.014; without normal maps or reliefs it is
/// 0.04 to 0.06.
constexpr double largest_rmse = 0.03;

}  // namespace

TEST_CASE("with the same settings a baseline and the step's program draw the same picture", "[baseline]") {
  REQUIRE(rivals().size() == 4);
  for (const Rivals& r : rivals()) {
    INFO(r.step.name);
    SettingValues ours = r.plan.rows.front().settings, theirs;
    // A relief so flat that neither program's number of layers is seen.
    if (follows_relief(r)) ours["parallax.depth"] = theirs["parallax.depth"] = 0.002;
    const Image colour = drawn(r.theirs, r, "colour", theirs), output = drawn(r.theirs, r, r.plan.output, theirs);
    // Mipmaps, rounding and the formulas of the biases differ, along the shadows' edges most: under one level of 255
    // on the whole. A wrong light, material or camera differs by ten times that.
    CHECK(error_of(drawn(r.ours, r, "colour", ours), colour, ErrorMetric::rmse) < 0.004);
    const double tolerance = allowed_for(r.plan.metric).alike;
    CHECK(error_of(drawn(r.ours, r, r.plan.output, ours), output, r.plan.metric, Encoding::data) < tolerance);
    // And there is something that could have been wrong: a shadow, a relief, a texture.
    const Image nothing(200, 150, Rgba{1, 1, 1, 1});
    CHECK(error_of(nothing, output, r.plan.metric, Encoding::data) > tolerance);
  }
}

TEST_CASE("a baseline sees the points of reliefs of any depth where the step's program sees them", "[baseline]") {
  int reliefs = 0;
  for (const Rivals& r : rivals()) {
    if (!follows_relief(r)) continue;
    ++reliefs;
    for (const double depth : {0.01, 0.03, 0.06}) {
      INFO(r.step.name << ", depth " << depth);
      const Image theirs = drawn(r.theirs, r, r.plan.output, {{"parallax.depth", depth}});
      SettingValues settings = r.plan.rows.front().settings;
      settings["parallax.depth"] = depth;
      const Image ours = drawn(r.ours, r, r.plan.output, settings);
      settings["parallax.method"] = std::string("none");
      const Image flat = drawn(r.ours, r, r.plan.output, settings);
      // The median, in pixels: 0.0006 at most. A relief whose depth is a fifth less moves the points by 0.03 and more.
      CHECK(error_of(ours, theirs, ErrorMetric::displacement, Encoding::data) < 0.005);
      CHECK(error_of(flat, theirs, ErrorMetric::displacement, Encoding::data) > 0.1);
      // Pixels whose ray passes a brick between two layers of one program, or leaves the wall in one: 0.9 % at most.
      CHECK(error_of(ours, theirs, ErrorMetric::misclassified, Encoding::data) < 0.02);
    }
  }
  CHECK(reliefs == 1);
}

TEST_CASE("the comparison with a baseline is complete", "[baseline]") {
  for (const Rivals& r : rivals()) {
    INFO(r.step.name);
    const Printed run = printed({"bench", r.step.name, "--baseline", "--repeats", "1", "--json"});
    REQUIRE(run.exit_status == 0);
    const auto& rows = run.json["baseline"];
    constexpr std::size_t baselines = 2;  // in floats, and in 8 bits
    REQUIRE(rows.size() == baselines + r.plan.rows.size());
    CHECK(rows[0]["name"] == r.plan.program);
    CHECK(mentions(rows[1]["name"].get<std::string>(), {r.plan.program, "frame.format=8", "texture.format=8"}));
    CHECK(rows[0]["ratio"] == 1);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      CHECK(rows[i]["seconds"].get<double>() > 0);
      CHECK(rows[i]["rmse"].get<double>() > 0);  // a picture of OpenGL's is never the truth to the last bit
      CHECK(rows[i]["rmse"].get<double>() < largest_rmse);
      CHECK(rows[i]["error"].get<double>() > 0);
      CHECK(rows[i]["error"].get<double>() < allowed_for(r.plan.metric).error);
      if (i < baselines) continue;
      const measure::BaselineRow& planned = r.plan.rows[i - baselines];
      CHECK(rows[i]["name"] == planned.name);
      CHECK(rows[i]["against"] == rows[planned.baseline_settings.empty() ? 0 : 1]["name"]);
      CHECK(rows[i]["ratio"].get<double>() > 0);
      CHECK(rows[i].contains("reached") == (planned.aim > 0));
    }
    CHECK(run.json["figures"].empty());
  }
}

TEST_CASE("the comparison with other packages is complete", "[baseline]") {
  int steps = 0;
  for (const CourseStep& step : course()) {
    if (!std::filesystem::exists(folders().root / "tests" / "peers" / step.name)) continue;
    INFO(step.name);
    ++steps;
    const Printed run = printed({"bench", step.name, "--baseline", "--repeats", "1", "--json"});
    REQUIRE(run.exit_status == 0);
    const nlohmann::json& rows = run.json["peers"];
    CHECK(!rows.empty());
    for (const auto& row : rows) {
      INFO(row.dump());
      CHECK(!row["work"].get<std::string>().empty());
      CHECK(row["ours"].get<double>() > 0);
      if (row.contains("missing")) continue;  // the package is optional
      CHECK(row["theirs"].get<double>() > 0);
      CHECK(row["least"].get<double>() == row["ratio"].get<double>());  // of one round
    }
  }
  CHECK(steps > 0);
}

TEST_CASE("a step without a baseline has nothing to compare", "[baseline]") {
  const Finished run = run_atelier({"bench", "01", "--baseline"});
  INFO(run.output);
  CHECK(run.exit_status == 2);
  CHECK(mentions(run.output, {"--baseline", "01-transforms"}));
}
