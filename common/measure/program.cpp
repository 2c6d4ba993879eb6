#include "measure/program.hpp"

#include <fmt/format.h>

#include <chrono>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/near_names.hpp"
#include "base/printable.hpp"
#include "base/process.hpp"
#include "base/strict_json.hpp"
#include "case/exchange.hpp"
#include "case/setting_json.hpp"
#include "judge/run/runner.hpp"

namespace atelier::measure {
namespace {

namespace fs = std::filesystem;
using strict_json::Json;

constexpr std::chrono::hours time_limit{2};     ///< of one run with all its cases; tracing is slow
constexpr std::chrono::seconds list_limit{20};  ///< of --list, which draws nothing
constexpr std::size_t stats_limit = 1 << 16;    ///< bytes of a NAME.stats

std::map<std::string, std::string> environment_of(const Program& program) {
  judge::RunSettings settings;
  settings.shader_cache = program.shader_cache;
  settings.environment["GALLIVM_PERF"] = "";
  return judge::program_environment(settings);
}

std::string run(const Program& program, std::vector<std::string> arguments, std::chrono::milliseconds limit) {
  arguments.insert(arguments.begin(), program.file.string());
  arguments.insert(arguments.end(), {"--implementations", program.implementations.to_string()});
  const Finished finished =
      run_process({.arguments = arguments, .folder = {}, .environment = environment_of(program), .time_limit = limit});
  if (finished.ok()) return finished.output;
  const std::string how = finished.signal      ? signal_name(finished.signal)
                          : finished.timed_out ? "it exceeded the time limit"
                                               : fmt::format("exit status {}", finished.exit_status);
  throw Error(
      fmt::format("{}: {}: {}", program.file.filename().string(), how, shorten(printable(finished.output), 600)));
}

/// Runs the program on the cases with `options`, then calls `take` for each case with the folder of the answers.
template <class Take>
void answer(const Program& program, const std::vector<Case>& cases, const std::vector<std::string>& options,
            Take take) {
  if (cases.empty()) return;
  const TemporaryFolder folder("atelier-measure");
  Json job = {{"cases", Json::array()}};
  for (const Case& c : cases) job["cases"].push_back(to_json(c));
  const fs::path file = folder.path() / "cases.json";
  const HeldFolder out = folder.held().create_folder("out");
  write_file(file, job.dump());
  std::vector<std::string> arguments = {"--cases", file.string(), "--out", out.path().string()};
  arguments.insert(arguments.end(), options.begin(), options.end());
  run(program, arguments, time_limit);
  for (const Case& c : cases) {
    for (const char* kind : {".build_error", ".error", ".exception"})
      if (const std::string words = read_case_error(out, c.name + kind); !words.empty())
        throw Error(fmt::format("{}: scene '{}': {}", program.file.filename().string(), c.scene, words));
    take(out, c);
  }
}

Cost read_cost(const HeldFolder& out, const std::string& where) {
  constexpr double largest = 1e9;  // seconds, or frames
  Cost cost;
  for (const auto& [name, count] : read_counts(out, where)) cost.counts[name] = double(count);
  const Json json = strict_json::parse(read_file(out.path() / where, stats_limit), where);
  if (const Json* frames = strict_json::optional(json, "frames")) {
    const auto member = [&](const char* name) {
      return strict_json::number(strict_json::required(*frames, name, where), where + ": frames: " + name, 0, largest);
    };
    cost.times = {.count = int(member("count")),
                  .median = member("median_s"),
                  .least = member("least_s"),
                  .most = member("most_s")};
  }
  return cost;
}

SettingSpec setting_of(const Json& json) {
  SettingSpec spec{.name = json.at("name").get<std::string>()};
  spec.fallback = setting_from_json(json.at("default"), spec.name + ": default");
  if (json.contains("choices")) spec.choices = json["choices"].get<std::vector<std::string>>();
  if (json.contains("range")) spec.low = json["range"][0], spec.high = json["range"][1];
  return spec;
}

}  // namespace

std::vector<std::string> Listing::output_names() const {
  std::vector<std::string> names;
  for (const OutputSpec& output : outputs) names.push_back(output.name);
  return names;
}

Encoding Listing::encoding_of(const std::string& output) const {
  for (const OutputSpec& spec : outputs)
    if (spec.name == output) return spec.encoding;
  return Encoding::data;
}

Listing list_of(const Program& program) {
  const std::string text = run(program, {"--list", "--json"}, list_limit);
  Listing listing;
  try {
    const Json json = Json::parse(text);
    for (const Json& setting : json.at("settings")) listing.settings.push_back(setting_of(setting));
    for (const Json& output : json.at("outputs")) {
      const std::string encoding = output.at("encoding");
      listing.outputs.push_back({.name = output.at("name"),
                                 .encoding = encoding == "linear colour"    ? Encoding::linear
                                             : encoding == "encoded colour" ? Encoding::srgb
                                                                            : Encoding::data,
                                 .help = output.at("help"),
                                 .stage = stage_named(output.at("stage").get<std::string>())});
    }
  } catch (const Json::exception& error) {
    throw Error(fmt::format("{} --list --json: {}", program.file.filename().string(), error.what()));
  }
  return listing;
}

double count_of(const Cost& cost, const std::string& name, const std::string& where) {
  if (const auto found = cost.counts.find(name); found != cost.counts.end()) return found->second;
  std::vector<std::string> known;
  for (const auto& [other, count] : cost.counts) known.push_back(other);
  throw Error(fmt::format("{}: the program does not count '{}'{}", where, name, suggestion(name, known)));
}

std::vector<Drawn> draw(const Program& program, const std::vector<Case>& cases, int repeats) {
  std::vector<std::string> options = {"--stats"};
  if (repeats > 0) options.insert(options.end(), {"--repeat", std::to_string(repeats)});
  if (!program.context.empty()) options.insert(options.end(), {"--context", program.context});
  std::vector<Drawn> drawn;
  answer(program, cases, options, [&](const HeldFolder& out, const Case& c) {
    drawn.push_back({read_pixels(out, c.name + ".pixels", c.size), read_cost(out, c.name + ".stats")});
  });
  return drawn;
}

std::vector<Image> trace(const Program& program, const std::vector<Case>& cases, int samples) {
  std::vector<Image> truths;
  answer(program, cases, {"--truth", "--samples", std::to_string(samples)},
         [&](const HeldFolder& out, const Case& c) { truths.push_back(read_pixels(out, c.name + ".pixels", c.size)); });
  return truths;
}

}  // namespace atelier::measure
