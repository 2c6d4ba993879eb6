#include "cli/author/truth_agreement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/process.hpp"
#include "case/exchange.hpp"

namespace atelier {

using judge::JudgedCase;
using judge::Unit;

namespace {

Case showing(Case ask, const std::string& output) {
  ask.name += "-" + output;
  ask.output = output;
  return ask;
}

/// Pixels within one pixel of an edge of the truth: where node, surface or colour change.
Mask near_edges(const std::string& name, const std::map<std::string, Image>& truth, const Compared& how) {
  const Image& shown = truth.at(name);
  const Image nothing(shown.width(), shown.height());  // the triangle has only colours
  const auto picture = [&](const char* output) -> const Image& {
    const auto found = truth.find(name + output);
    return found == truth.end() ? nothing : found->second;
  };
  const Image &things = picture("-thing"), &normals = picture("-normal"), &depths = picture("-depth");
  const Image colours = as_compared(shown, how);
  const auto apart = [](const Rgba& a, const Rgba& b) {
    return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
  };
  Mask mask(shown.width(), shown.height());
  for (int y = 0; y < shown.height(); ++y)
    for (int x = 0; x < shown.width(); ++x)
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          const int u = std::clamp(x + dx, 0, shown.width() - 1), v = std::clamp(y + dy, 0, shown.height() - 1);
          if (things.at(x, y).r != things.at(u, v).r || apart(normals.at(x, y), normals.at(u, v)) > 0.05f ||
              apart(depths.at(x, y), depths.at(u, v)) > 0.01f || apart(colours.at(x, y), colours.at(u, v)) > 0.05f)
            mask.set(x, y, true);
        }
  return mask;
}

}  // namespace

Compared closeness(const JudgedCase& c) {
  switch (c.unit) {
    case Unit::degrees:
      return {Measure::degrees, 0.1, false};  // 2^-11 on each component: 0.05 degrees
    case Unit::number:
      return {Measure::number, 1e-3, false};  // texture coordinates up to 2: 2^-11 of them
    case Unit::encoded:
      return {.linear = false};
    default:
      return {.exposure = c.exposure};
  }
}

Image as_compared(Image image, const Compared& how) {
  return how.linear ? encode_for_comparison(std::move(image), float(how.exposure)) : image;
}

std::vector<JudgedCase> pictures_of(const ProjectFolders& folders, const CourseStep& step) {
  auto cases = judge::read_case_file(folders.case_file(step.name)).cases;
  std::erase_if(cases, [](const JudgedCase& c) { return !c.ask.probe.empty(); });
  return cases;
}

std::vector<Case> asks_of(const std::vector<JudgedCase>& cases) {
  std::vector<Case> asks;
  for (const JudgedCase& c : cases) asks.push_back(c.ask);
  return asks;
}

std::vector<Case> with_edges(const std::vector<Case>& asks) {
  std::vector<Case> all;
  for (const Case& ask : asks) {
    all.push_back(ask);
    for (const char* output : {"thing", "normal", "depth"}) all.push_back(showing(ask, output));
  }
  return all;
}

std::map<std::string, Image> truths(const Workshop& workshop, const Version& version, const std::vector<Case>& asks,
                                    int samples) {
  const TemporaryFolder folder("atelier-truth");
  nlohmann::json cases = nlohmann::json::array();
  for (const Case& ask : asks) cases.push_back(to_json(ask));
  write_file(folder.path() / "cases.json", nlohmann::json{{"cases", cases}}.dump());
  const judge::RunSettings settings = workshop.settings(version);
  const Finished finished =
      run_process({.arguments = {settings.program.string(), "--truth", "--samples", std::to_string(samples), "--cases",
                                 (folder.path() / "cases.json").string(), "--out", folder.path().string(),
                                 "--implementations", settings.implementations.to_string()}});
  if (!finished.ok()) throw Error(fmt::format("{} --truth: {}", workshop.step().name, finished.output));
  std::map<std::string, Image> traced;
  for (const Case& ask : asks)
    if (const std::string file = ask.name + ".pixels"; folder.held().has(file))
      traced[ask.name] = read_pixels(folder.held(), file, ask.size);
  return traced;
}

std::string in_words(const Agreement& a) {
  return fmt::format(
      "{} pixels differ ({:.3f} %), {} of them by more than a pixel's shift, {} away from edges; worst "
      "{:.2f} at {}, {}",
      a.strict.over, 100 * a.strict.share, a.robust.over, a.away_from_edges, a.strict.worst_distance, a.strict.worst.x,
      a.strict.worst.y);
}

Agreement agreement(const std::string& name, const Image& drawn, const std::map<std::string, Image>& truth,
                    const Compared& how) {
  const Image yours = as_compared(drawn, how), exact = as_compared(truth.at(name), how);
  Agreement found{compare_strict(yours, exact, how.measure, how.delta),
                  compare_robust(yours, exact, how.measure, how.delta)};
  const Mask edges = near_edges(name, truth, how);
  for (int y = 0; y < edges.height(); ++y)
    for (int x = 0; x < edges.width(); ++x) found.away_from_edges += found.strict.mask.at(x, y) && !edges.at(x, y);
  return found;
}

}  // namespace atelier
