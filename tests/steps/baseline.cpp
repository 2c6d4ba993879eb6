// Baselines draw the same pictures as the steps, without which a comparison of times is meaningless; and the comparison
// is complete. No time is asserted on.
#include <set>

#include "base/error.hpp"
#include "base/file.hpp"
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

Image drawn(const measure::Program& program, const Rivals& r, const std::string& output, bool ours) {
  Case picture{.name = "picture", .scene = r.plan.scene, .size = {200, 150}, .output = output};
  if (ours) picture.settings = r.plan.rows.front().settings;
  // A relief so flat that neither program's number of layers is seen.
  if (r.plan.metric == ErrorMetric::distance) picture.settings["parallax.depth"] = 0.002;
  return measure::draw(program, {picture}).front().picture;
}

}  // namespace

namespace {

/// How far the output that a plan compares may differ between two programs that draw the same.
double alike(ErrorMetric metric) {
  switch (metric) {
    // Faces that turn away from the light are in each program's shadow as its bias has it, and dark in both: the demo
    // of the sun shows one from below, 1.5 % of the picture.
    case ErrorMetric::wrong:
      return 0.02;
    // The same maps and frames: only rounding, and the order of interpolation.
    case ErrorMetric::degrees:
      return 0.1;
    // Other layers, so other points at the bricks' sides: a twentieth of the relief's depth.
    case ErrorMetric::distance:
      return 1e-4;
    default:
      throw Error("a baseline with a metric that no other has: say how alike the programs are");
  }
}

}  // namespace

TEST_CASE("with the same settings a baseline and the step's program draw the same picture", "[baseline]") {
  REQUIRE(rivals().size() == 4);
  for (const Rivals& r : rivals()) {
    INFO(r.step.name);
    const Image colour = drawn(r.theirs, r, "colour", false), output = drawn(r.theirs, r, r.plan.output, false);
    // Mipmaps, rounding and the formulas of the biases differ, along the shadows' edges most: under one level of 255
    // on the whole. A wrong light, material or camera differs by ten times that.
    CHECK(error_of(drawn(r.ours, r, "colour", true), colour, ErrorMetric::rmse) < 0.004);
    const double tolerance = alike(r.plan.metric);
    CHECK(error_of(drawn(r.ours, r, r.plan.output, true), output, r.plan.metric, Encoding::data) < tolerance);
    // And there is something that could have been wrong: a shadow, a relief, a texture.
    const Image nothing(200, 150, Rgba{1, 1, 1, 1});
    CHECK(error_of(nothing, output, r.plan.metric, Encoding::data) > tolerance);
  }
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
      CHECK(rows[i]["error"].get<double>() > 0);
      if (i < baselines) continue;
      const measure::BaselineRow& planned = r.plan.rows[i - baselines];
      CHECK(rows[i]["name"] == planned.name);
      CHECK(rows[i]["against"] == rows[planned.baseline_settings.empty() ? 0 : 1]["name"]);
      CHECK(rows[i]["ratio"].get<double>() > 0);
      CHECK(rows[i].contains("reached") == (planned.aim > 0));
    }
    CHECK(run.json["figures"].empty());
    CHECK(run.json.contains("peers") == r.step.name.starts_with("05"));
  }
}

TEST_CASE("a step without a baseline has nothing to compare", "[baseline]") {
  const Finished run = run_atelier({"bench", "01", "--baseline"});
  INFO(run.output);
  CHECK(run.exit_status == 2);
  CHECK(mentions(run.output, {"--baseline", "01-transforms"}));
}

TEST_CASE("the comparison with other packages is complete", "[baseline]") {
  const Printed run = printed({"bench", "05", "--baseline", "--repeats", "1", "--json"});
  REQUIRE(run.exit_status == 0);
  const auto& rows = run.json["peers"];
  REQUIRE(rows.size() == 6);  // two functions, three sizes
  for (const auto& row : rows) {
    INFO(row.dump());
    CHECK(mentions(row["work"].get<std::string>(), {"tangents", "triangles"}));
    CHECK(row["ours"].get<double>() > 0);
    if (row.contains("missing")) continue;  // the package is optional
    CHECK(row["theirs"].get<double>() > 0);
    CHECK(row["least"].get<double>() == row["ratio"].get<double>());  // of one round
  }
}
