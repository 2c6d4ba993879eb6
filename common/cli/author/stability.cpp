// ./atelier stability: tests every function with extreme inputs, and plots how the error grows.
//
// tests/stability/ has the rows and the sweeps; each table has its own program, because it runs the code of steps. This
// command runs them, sorts the worst rows first, and plots the sweeps.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/csv.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/process.hpp"
#include "cli/commands.hpp"
#include "cli/layout.hpp"
#include "cli/search_path.hpp"
#include "measure/plot.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;
using OrderedJson = nlohmann::ordered_json;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr std::size_t worst_shown = 20;

struct StabilityRow {
  std::string table, function, extreme, demand, unit, reason, words;
  double error = 0, bound = 0;
  bool held = false;

  /// Error divided by bound: at most 1 if the row holds, infinite if unknown.
  double used() const { return bound > 0 ? error / bound : error > 0 || !held ? infinite : 0; }
};

StabilityRow row_of(const std::string& table, const OrderedJson& json) {
  return {.table = table,
          .function = json.at("function"),
          .extreme = json.at("extreme"),
          .demand = json.at("demand"),
          .unit = json.at("unit"),
          .reason = json.at("reason"),
          .words = json.at("words"),
          .error = json.at("error").is_null() ? infinite : json.at("error").get<double>(),
          .bound = json.at("bound"),
          .held = json.at("held")};
}

/// All tables, or the requested one.
std::vector<std::string> tables_of(const std::vector<CourseStep>& course, const std::string& asked) {
  if (asked == "common") return {"common"};
  if (!asked.empty()) return {resolve_step(course, asked).name};
  std::vector<std::string> names = {"common"};
  for (const CourseStep& step : course) names.push_back(step.name);
  return names;
}

fs::path program_of(const ProjectFolders& folders, const std::string& table) {
  return folders.build / "bin" / ("stability-" + table);
}

/// The output of the table's program.
OrderedJson try_table(const ProjectFolders& folders, const CourseStep& step, const fs::path& out) {
  const std::string& table = step.name;
  const fs::path file = out / (table + ".json");
  std::error_code none;
  fs::remove(file, none);  // do not read an old result
  const Implementations solutions = search_path(folders, step, code_of(folders, Owner::solution), {});
  const Finished finished =
      run_process({.arguments = {program_of(folders, table), solutions.to_string(), file.string()}});
  if (!finished.ok())
    throw Error(fmt::format("stability of {}: {}", table,
                            finished.signal ? signal_name(finished.signal) : finished.output.substr(0, 500)));
  return OrderedJson::parse(read_file(file));
}

void write_rows(const std::vector<StabilityRow>& rows, const fs::path& file) {
  std::string csv = "table,function,extreme,demand,error,bound,unit,held,reason,words\n";
  for (const StabilityRow& r : rows)
    csv +=
        fmt::format("{},{},{},{},{},{},{},{},{},{}\n", csv_field(r.table), csv_field(r.function), csv_field(r.extreme),
                    r.demand, r.error, r.bound, csv_field(r.unit), r.held, csv_field(r.reason), csv_field(r.words));
  write_file(file, csv);
}

measure::Plot plot_of(const OrderedJson& sweep) {
  const auto scale = [&](const char* member) {
    return sweep.at(member) ? measure::Scale::logarithmic : measure::Scale::linear;
  };
  measure::Plot plot{.title = sweep.at("title"),
                     .x = {.label = sweep.at("x"), .scale = scale("log_x")},
                     .y = {.label = sweep.at("y"), .scale = scale("log_y")}};
  for (const OrderedJson& curve : sweep.at("curves")) {
    measure::Curve drawn{.title = curve.at("name")};
    for (const OrderedJson& p : curve.at("points")) drawn.points.emplace_back(p.at(0), p.at(1));
    plot.curves.push_back(std::move(drawn));
  }
  return plot;
}

std::string sweep_as_csv(const OrderedJson& sweep) {
  std::string csv = fmt::format("curve,{},{}\n", csv_field(sweep.at("x")), csv_field(sweep.at("y")));
  for (const OrderedJson& curve : sweep.at("curves"))
    for (const OrderedJson& p : curve.at("points"))
      csv += fmt::format("{},{},{}\n", csv_field(curve.at("name")), p.at(0).get<double>(), p.at(1).get<double>());
  return csv;
}

/// Writes the sweep as numbers and, if `with_plot`, as a plot.
void write_sweep(const OrderedJson& sweep, const fs::path& out, bool with_plot) {
  const std::string name = sweep.at("name");
  write_file(out / (name + ".csv"), sweep_as_csv(sweep));
  if (with_plot) write_file(out / (name + ".svg"), measure::plot_as_svg(plot_of(sweep)));
}

void print_row(const StabilityRow& row) {
  const std::string used = std::isinf(row.used()) ? "-" : fmt::format("{:.3f}", row.used());
  const std::string measured =
      row.bound > 0 ? fmt::format("{:.2g} of {:.2g} {}", row.error, row.bound, row.unit) : row.demand;
  fmt::print("{} {:>6}  {:<30} {:<58} {}\n", row.held ? "   " : "NOT", used, row.function, row.extreme, measured);
  if (row.held) return;
  if (!row.reason.empty()) fmt::print("              the bound: {}\n", row.reason);
  if (row.bound == 0) fmt::print("              error {}\n", row.error);
  if (!row.words.empty()) fmt::print("              it threw: {}\n", row.words);
}

void print_rows(std::vector<StabilityRow> rows, bool all) {
  std::stable_sort(rows.begin(), rows.end(), [](const StabilityRow& a, const StabilityRow& b) {
    return a.held != b.held ? !a.held : a.used() > b.used();
  });
  const auto broken =
      std::size_t(std::count_if(rows.begin(), rows.end(), [](const StabilityRow& r) { return !r.held; }));
  const std::size_t shown = all ? rows.size() : std::min(rows.size(), broken + worst_shown);
  fmt::print("{:>10}  {:<30} {:<58} {}\n", "of bound", "function", "extreme", "error");
  for (std::size_t i = 0; i < shown; ++i) print_row(rows[i]);
  if (shown < rows.size())
    fmt::print("{:>10}  and {} more, further from their bounds (--all)\n", "", rows.size() - shown);
  fmt::print("\n{} of {} rows hold\n", rows.size() - broken, rows.size());
}

}  // namespace

int run_stability(const StabilityOptions& options) {
  const ProjectFolders folders = project_folders();
  const auto course = read_course(folders.step_flags());
  const fs::path out = options.out.empty() ? folders.out() / "stability" : options.out;
  std::vector<std::string> tables = tables_of(course, options.step);
  std::erase_if(tables, [&](const std::string& table) { return !fs::exists(program_of(folders, table)); });
  if (tables.empty())
    throw Error(fs::exists(folders.root / "tests" / "stability")
                    ? "there is no table of extremes for this step; see tests/stability/"
                    : "a release has no tests of its own; ./atelier check STEP judges your files");

  fs::create_directories(out);
  const bool with_plots = measure::can_plot();
  std::vector<StabilityRow> rows;
  OrderedJson answers = OrderedJson::array();
  for (const std::string& table : tables) {
    const auto step = std::find_if(course.begin(), course.end(), [&](const CourseStep& s) { return s.name == table; });
    const OrderedJson answer = try_table(folders, step == course.end() ? CourseStep{.name = table} : *step, out);
    for (const OrderedJson& row : answer.at("rows")) rows.push_back(row_of(table, row));
    for (const OrderedJson& sweep : answer.at("sweeps")) write_sweep(sweep, out, with_plots);
    answers.push_back(answer);
  }
  write_rows(rows, out / "rows.csv");

  if (options.json) {
    fmt::print("{}\n", OrderedJson{{"tables", answers}}.dump(2));
  } else {
    print_rows(rows, options.all);
    fmt::print("All rows{} are in {}\n", with_plots ? " and the plots" : " and, without gnuplot, the plots' numbers",
               out.string());
  }
  return std::all_of(rows.begin(), rows.end(), [](const StabilityRow& r) { return r.held; }) ? exit_ok : exit_failed;
}

}  // namespace atelier
