// Pictures whose times are compared show the same where ratios.json says so, without which their ratio is meaningless;
// and the comparison is complete. No time is asserted on.
#include "catch.hpp"
#include "cli/author/bench.hpp"
#include "command.hpp"
#include "image/error.hpp"

using namespace atelier;
using namespace atelier::test;
using nlohmann::json;

namespace {

std::vector<CourseStep> steps_with_ratios() {
  std::vector<CourseStep> steps = steps_in_turn();
  std::erase_if(steps,
                [](const CourseStep& step) { return !std::filesystem::exists(folders().ratios_file(step.name)); });
  return steps;
}

}  // namespace

TEST_CASE("pictures that are compared in time are alike", "[ratios][each-step]") {
  for (const CourseStep& step : steps_with_ratios())
    for (const measure::RatioRow& row : measure::read_ratio_plan(folders().ratios_file(step.name)).rows) {
      if (!row.alike) continue;
      INFO(step.name << ": " << row.name);
      const auto both = measure::draw(solved_program(folders(), step), {row.picture, row.beside});
      CHECK(error_of(both[0].picture, both[1].picture, ErrorMetric::rmse) <= *row.alike);
    }
}

TEST_CASE("the comparison of frames with one another is complete", "[ratios][each-step]") {
  for (const CourseStep& step : steps_with_ratios()) {
    INFO(step.name);
    const measure::RatioPlan plan = measure::read_ratio_plan(folders().ratios_file(step.name));
    const Printed run = printed({"bench", step.name, "--baseline", "--repeats", "1", "--json"});
    REQUIRE(run.exit_status == 0);
    const json& rows = run.json["ratios"];
    REQUIRE(rows.size() == plan.rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const json& row = rows[i];
      INFO(row.dump());
      CHECK(row["name"] == plan.rows[i].name);
      CHECK(row["seconds"].get<double>() > 0);
      CHECK(row["ratio"].get<double>() == Approx(row["seconds"].get<double>() / row["beside_seconds"].get<double>()));
      CHECK(row["least"] == row["most"]);  // of one round
      CHECK(row["held"].is_boolean());
      CHECK(row.contains("at_most") == plan.rows[i].at_most.has_value());
      CHECK(row.contains("difference") == plan.rows[i].alike.has_value());
      for (const std::string& count : plan.counts) CHECK(row["counts"][count].size() == 2);
    }
  }
}
