// Compares a step's work with that of packages: BUILD/bin/peers-NN-name, if the step has one.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/process.hpp"
#include "cli/author/bench.hpp"
#include "measure/median.hpp"

namespace atelier {
namespace {

namespace fs = std::filesystem;
using measure::median;

/// From what the program writes (tests/peers/peers.hpp).
PeerRow row_of(const nlohmann::json& json) {
  PeerRow row{.work = json.at("work"), .peer = json.at("peer"), .aim = json.value("aim", 0.0)};
  const auto ours = json.at("ours").get<std::vector<double>>();
  row.ours = median(ours);
  row.missing = json.value("missing", "");
  if (!row.missing.empty()) return row;
  const auto theirs = json.at("theirs").get<std::vector<double>>();
  row.theirs = median(theirs);
  std::vector<double> ratios;
  for (std::size_t round = 0; round < ours.size(); ++round) ratios.push_back(theirs.at(round) / ours[round]);
  row.ratio = median(ratios);
  row.least = *std::ranges::min_element(ratios);
  row.most = *std::ranges::max_element(ratios);
  return row;
}

}  // namespace

std::vector<PeerRow> bench_peers(const ProjectFolders& folders, const CourseStep& step, int repeats) {
  const fs::path program = folders.program("peers-" + step.name);
  if (!fs::exists(program)) return {};
  const Finished run = run_process({.arguments = {program.string(), std::to_string(repeats)}});
  if (!run.ok()) throw Error(fmt::format("{} failed: {}", program.string(), run.output.substr(0, 500)));
  std::vector<PeerRow> rows;
  try {
    const nlohmann::json written = nlohmann::json::parse(run.output);
    for (const auto& json : written.at("rows")) rows.push_back(row_of(json));
  } catch (const nlohmann::json::exception& wrong) {
    throw Error(fmt::format("{} wrote no rows: {}", program.string(), wrong.what()));
  }
  return rows;
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
