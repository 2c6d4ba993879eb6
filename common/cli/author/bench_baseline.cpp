// Compares a step's frame times with a baseline: tests/cases/NN-name/baseline.json, if the step has one.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "cli/author/bench.hpp"
#include "cli/search_path.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;

}  // namespace

measure::Program solved_program(const ProjectFolders& folders, const CourseStep& step) {
  measure::Program program{.file = folders.program(step.name)};
  program.implementations = search_path(folders, step, code_of(folders, Owner::solution), {});
  program.shader_cache = folders.build / "cache" / "measure-shaders";
  return program;
}

std::optional<BaselineTable> bench_baseline(const ProjectFolders& folders, const CourseStep& step, int repeats) {
  const fs::path file = folders.baseline_file(step.name);
  if (!fs::exists(file)) return {};
  BaselineTable table{.plan = measure::read_baseline_plan(file)};
  const fs::path program = folders.program(table.plan.program);
  if (!fs::exists(program)) throw Error(fmt::format("{}: is missing: build the target 'baselines'", program.string()));
  const measure::Program ours = solved_program(folders, step);
  measure::Program other = ours;
  other.file = program;
  table.compared = measure::compare_with_baseline(table.plan, ours, other, repeats, timed_frames);
  return table;
}

void print_baseline(const BaselineTable& table) {
  const auto& plan = table.plan;
  fmt::print("\n{} at {}x{}: frames beside those of {}, drawn by one thread\n", plan.scene, plan.size.x, plan.size.y,
             plan.program);
  fmt::print("{:<64} {:>10} {:>9} {:>15} {:>12} {:>20}  {}\n", "", "median", "faster", "from .. to", "colour rmse",
             plan.output + " " + to_string(plan.metric), "aim");
  const auto line = [](const measure::Compared& row, const std::string& range, const std::string& aim) {
    fmt::print("{:<64} {:>7.2f} ms {:>8.2f}x {:>15} {:>12.5f} {:>20.3g}  {}\n", row.name, row.seconds * 1e3, row.ratio,
               range, row.rmse, row.error, aim);
  };
  for (std::size_t b = 0; b < table.compared.baselines.size(); ++b) {
    const measure::Compared& baseline = table.compared.baselines[b];
    line(baseline, "-", "-");
    for (std::size_t i = 0; i < plan.rows.size(); ++i) {
      const measure::Compared& row = table.compared.rows[i];
      if (row.against != b) continue;
      const measure::BaselineRow& planned = plan.rows[i];
      const std::string aim = planned.aim > 0 ? fmt::format("{:.2f}x{} {}", planned.aim,
                                                            planned.no_larger_error ? " at no larger error" : "",
                                                            measure::reaches_aim(planned, row, baseline) ? "✓" : "✗")
                                              : "-";
      line(row, fmt::format("{:.2f}..{:.2f}", row.least, row.most), aim);
    }
  }
}

namespace {

nlohmann::ordered_json as_json(const measure::Compared& row) {
  return {{"name", row.name}, {"seconds", row.seconds}, {"ratio", row.ratio}, {"least", row.least},
          {"most", row.most}, {"rmse", row.rmse},       {"error", row.error}};
}

}  // namespace

nlohmann::ordered_json baseline_as_json(const BaselineTable& table) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const measure::Compared& baseline : table.compared.baselines) list.push_back(as_json(baseline));
  for (std::size_t i = 0; i < table.plan.rows.size(); ++i) {
    const measure::Compared& row = table.compared.rows[i];
    const measure::Compared& baseline = table.compared.baselines[row.against];
    nlohmann::ordered_json json = as_json(row);
    json["against"] = baseline.name;
    if (table.plan.rows[i].aim > 0) {
      json["aim"] = table.plan.rows[i].aim;
      json["reached"] = measure::reaches_aim(table.plan.rows[i], row, baseline);
    }
    list.push_back(std::move(json));
  }
  return list;
}

}  // namespace atelier
