// ./atelier bench: medians, compared with the project's targets.
#include "cli/author/bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "base/error.hpp"

namespace atelier {
namespace {

void print_table(const std::vector<Figure>& figures) {
  fmt::print("{:<26} {:>10} {:>10} {:>10} {:>14}  {}\n", "figure", "median", "least", "most", "of the aim", "of what");
  const auto ms = [](double seconds) { return fmt::format("{:.1f} ms", seconds * 1e3); };
  for (const Figure& f : figures)
    fmt::print("{:<26} {:>10} {:>10} {:>10} {:>14}  {}\n", f.name, ms(f.seconds), ms(f.least), ms(f.most),
               f.limit > 0 ? fmt::format("{:.0f} % of {}", 100 * f.seconds / f.limit, ms(f.limit)) : "-", f.detail);
}

void print_json(const std::vector<Figure>& figures, const std::optional<BaselineTable>& table,
                const std::optional<RatioTable>& ratios, const std::vector<PeerRow>& peers) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Figure& f : figures)
    list.push_back({{"name", f.name},
                    {"detail", f.detail},
                    {"seconds", f.seconds},
                    {"least", f.least},
                    {"most", f.most},
                    {"aim", f.limit > 0 ? nlohmann::ordered_json(f.limit) : nullptr}});
  nlohmann::ordered_json all = {{"figures", list}};
  if (table) all["baseline"] = baseline_as_json(*table);
  if (ratios) all["ratios"] = ratios_as_json(*ratios);
  if (!peers.empty()) all["peers"] = peers_as_json(peers);
  fmt::print("{}\n", all.dump(2));
}

}  // namespace

Figure time_runs(std::string name, std::string detail, int repeats, const std::function<void()>& action,
                 const std::function<void()>& prepare) {
  using Clock = std::chrono::steady_clock;
  std::vector<double> seconds;
  for (int i = 0; i < repeats; ++i) {
    if (prepare) prepare();
    const auto begin = Clock::now();
    action();
    seconds.push_back(std::chrono::duration<double>(Clock::now() - begin).count());
  }
  std::sort(seconds.begin(), seconds.end());
  return {.name = std::move(name),
          .detail = std::move(detail),
          .seconds = seconds[seconds.size() / 2],
          .least = seconds.front(),
          .most = seconds.back()};
}

int run_bench(const BenchOptions& options) {
  const ProjectFolders folders = project_folders();
  const auto course = read_course(folders.step_flags());
  if (options.submissions > 0) {
    bench_class(folders, course, options.submissions);
    return exit_ok;
  }
  const CourseStep& step = resolve_step(course, options.step);
  std::vector<Figure> figures;
  if (!options.baseline) {
    figures = bench_commands(folders, course, step, options.repeats);
    const std::vector<Figure> parts = bench_parts(options.repeats);
    figures.insert(figures.end(), parts.begin(), parts.end());
  }
  const std::optional<BaselineTable> table = bench_baseline(folders, step, options.repeats);
  const std::vector<PeerRow> peers = bench_peers(folders, step, options.repeats);
  const std::optional<RatioTable> ratios = bench_ratios(folders, step, options.repeats);
  if (options.baseline && !table && !ratios && peers.empty())
    throw Error(fmt::format("--baseline: {} has nothing to compare with", step.name));
  if (options.json) {
    print_json(figures, table, ratios, peers);
  } else {
    if (!figures.empty()) print_table(figures);
    if (table) print_baseline(*table);
    if (ratios) print_ratios(*ratios);
    print_peers(peers);
  }
  return exit_ok;
}

}  // namespace atelier
