// Compares a step's work with that of packages: BUILD/bin/peers-NN-name, if the step has one.
#include <fmt/format.h>

#include <chrono>

#include "base/error.hpp"
#include "base/printable.hpp"
#include "base/process.hpp"
#include "base/strict_json.hpp"
#include "cli/author/bench.hpp"
#include "measure/median.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;
using measure::median;
using strict_json::Json;

/// Of a program with this many rounds: some ten times what the slowest takes.
std::chrono::seconds time_limit(int rounds) {
  return std::chrono::seconds(120 + 60 * rounds);
}

/// The member `name` of a row: seconds, one number for each round.
std::vector<double> times_of(const Json& row, const char* name, int rounds, const std::string& where) {
  const std::string place = where + ": " + name;
  const Json& list = strict_json::required(row, name, where);
  if (!list.is_array() || list.size() != std::size_t(rounds))
    strict_json::refuse(list, place, fmt::format("a list of {} numbers, one for each round", rounds));
  std::vector<double> times;
  for (const Json& time : list) times.push_back(strict_json::number(time, place, 1e-9, 1e6));
  return times;
}

PeerRow row_of(const Json& json, int rounds, const std::string& where) {
  const bool missing = json.contains("missing");
  strict_json::refuse_unknown(json, {"work", "peer", "aim", "ours", missing ? "missing" : "theirs"}, where);
  const auto text = [&](const char* name) {
    return strict_json::text(strict_json::required(json, name, where), where + ": " + name);
  };
  PeerRow row{.work = text("work"), .peer = text("peer")};
  if (const Json* aim = strict_json::optional(json, "aim"))
    row.aim = strict_json::number(*aim, where + ": aim", 0.1, 100);
  const std::vector<double> ours = times_of(json, "ours", rounds, where);
  row.ours = median(ours);
  if (missing) {
    row.missing = text("missing");
    return row;
  }
  const std::vector<double> theirs = times_of(json, "theirs", rounds, where);
  row.theirs = median(theirs);
  std::vector<double> ratios;
  for (std::size_t round = 0; round < ours.size(); ++round) ratios.push_back(theirs[round] / ours[round]);
  const measure::Spread ratio = measure::spread_of(ratios);
  row.ratio = ratio.median;
  row.least = ratio.least;
  row.most = ratio.most;
  return row;
}

}  // namespace

std::vector<PeerRow> parse_peers(std::string_view text, int rounds, const std::string& where) {
  const Json document = strict_json::parse(text, where);
  strict_json::refuse_unknown(document, {"rows"}, where);
  const Json& list = strict_json::required(document, "rows", where);
  if (!list.is_array() || list.empty()) strict_json::refuse(list, where + ": rows", "a list of at least one row");
  std::vector<PeerRow> rows;
  for (std::size_t i = 0; i < list.size(); ++i)
    rows.push_back(row_of(list[i], rounds, fmt::format("{}: row {}", where, i + 1)));
  return rows;
}

std::vector<PeerRow> bench_peers(const ProjectFolders& folders, const CourseStep& step, int repeats) {
  if (!fs::exists(folders.root / "tests" / "peers" / step.name)) return {};
  const fs::path program = folders.program("peers-" + step.name);
  const std::string name = program.string();
  if (!fs::exists(program)) throw Error(fmt::format("{}: is missing: build the target 'baselines'", name));
  const Finished run = run_process({.arguments = {name, std::to_string(repeats)}, .time_limit = time_limit(repeats)});
  if (run.timed_out)
    throw Error(fmt::format("{}: took longer than {} s for {} rounds and was killed", name, time_limit(repeats).count(),
                            repeats));
  if (run.signal != 0) throw Error(fmt::format("{}: crashed: {}", name, signal_name(run.signal)));
  if (!run.ok())
    throw Error(fmt::format("{}: exit status {}: {}", name, run.exit_status, shorten(printable(run.output), 600)));
  return parse_peers(run.output, repeats, name);
}

void print_peers(const std::vector<PeerRow>& rows) {
  if (rows.empty()) return;
  fmt::print("\n{:<36} {:<30} {:>11} {:>11} {:>9} {:>15}  {}\n", "by one thread", "beside", "ours", "theirs", "faster",
             "from .. to", "aim");
  const auto ms = [](double seconds) { return fmt::format("{:.2f} ms", seconds * 1e3); };
  for (const PeerRow& row : rows) {
    if (!row.missing.empty()) {
      fmt::print("{:<36} {:<30} {:>11} not installed: {}\n", row.work, row.peer, ms(row.ours), row.missing);
      continue;
    }
    const std::string aim =
        row.aim > 0 ? fmt::format("{:.2f}x {}", row.aim, row.ratio >= row.aim ? "✓" : "✗") : std::string("-");
    fmt::print("{:<36} {:<30} {:>11} {:>11} {:>8.2f}x {:>15}  {}\n", row.work, row.peer, ms(row.ours), ms(row.theirs),
               row.ratio, fmt::format("{:.2f}..{:.2f}", row.least, row.most), aim);
  }
}

nlohmann::ordered_json peers_as_json(const std::vector<PeerRow>& rows) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const PeerRow& row : rows) {
    nlohmann::ordered_json json = {{"work", row.work}, {"peer", row.peer}, {"ours", row.ours}};
    if (row.missing.empty())
      json.update({{"theirs", row.theirs}, {"ratio", row.ratio}, {"least", row.least}, {"most", row.most}});
    else
      json["missing"] = row.missing;
    if (row.aim > 0) json["aim"] = row.aim;
    list.push_back(std::move(json));
  }
  return list;
}

}  // namespace atelier
