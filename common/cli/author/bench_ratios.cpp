// Compares a step's frame times with one another: tests/cases/NN-name/ratios.json, if the step has one.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/author/bench.hpp"

namespace atelier {

std::optional<RatioTable> bench_ratios(const ProjectFolders& folders, const CourseStep& step, int repeats) {
  const std::filesystem::path file = folders.ratios_file(step.name);
  if (!std::filesystem::exists(file)) return {};
  RatioTable table{.plan = measure::read_ratio_plan(file)};
  table.measured = measure::measure_ratios(table.plan, solved_program(folders, step), repeats, timed_frames);
  return table;
}

void print_ratios(const RatioTable& table) {
  fmt::print("\n{:<60} {:>10} {:>10} {:>7} {:>14} {:>9}", "frames beside others, drawn by one thread", "median",
             "beside", "times", "from .. to", "at most");
  for (const std::string& count : table.plan.counts) fmt::print(" {:>21}", count);
  fmt::print("\n");
  const auto ms = [](double seconds) { return fmt::format("{:.2f} ms", seconds * 1e3); };
  for (std::size_t i = 0; i < table.plan.rows.size(); ++i) {
    const measure::RatioRow& row = table.plan.rows[i];
    const measure::MeasuredRatio& measured = table.measured[i];
    const std::string limit =
        row.at_most ? fmt::format("{:.2f}x {}", *row.at_most, measure::holds(row, measured) ? "✓" : "✗") : "-";
    fmt::print("{:<60} {:>10} {:>10} {:>6.2f}x {:>14} {:>9}", row.name, ms(measured.seconds),
               ms(measured.beside_seconds), measured.ratio.median,
               fmt::format("{:.2f}..{:.2f}", measured.ratio.least, measured.ratio.most), limit);
    for (std::size_t c = 0; c < measured.counts.size(); ++c)
      fmt::print(" {:>21}", fmt::format("{} / {}", measured.counts[c], measured.beside_counts[c]));
    fmt::print("\n");
    if (row.alike && !(measured.difference <= row.alike))
      fmt::print("{:<60} the pictures differ by {:.2g}, and may by {:.2g}\n", "", *measured.difference, *row.alike);
  }
}

nlohmann::ordered_json ratios_as_json(const RatioTable& table) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < table.plan.rows.size(); ++i) {
    const measure::RatioRow& row = table.plan.rows[i];
    const measure::MeasuredRatio& measured = table.measured[i];
    nlohmann::ordered_json json = {{"name", row.name},
                                   {"seconds", measured.seconds},
                                   {"beside_seconds", measured.beside_seconds},
                                   {"ratio", measured.ratio.median},
                                   {"least", measured.ratio.least},
                                   {"most", measured.ratio.most},
                                   {"held", measure::holds(row, measured)}};
    if (row.at_most) json["at_most"] = *row.at_most;
    if (measured.difference) json["difference"] = *measured.difference;
    for (std::size_t c = 0; c < measured.counts.size(); ++c)
      json["counts"][table.plan.counts[c]] = {measured.counts[c], measured.beside_counts[c]};
    list.push_back(std::move(json));
  }
  return list;
}

}  // namespace atelier
