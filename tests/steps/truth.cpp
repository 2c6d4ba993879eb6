// The references against the ground truth: what the solution draws is what the oracle traces, but for rounding at edges
// and for what a case says of itself.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "base/file.hpp"
#include "case/exchange.hpp"
#include "catch.hpp"
#include "cli/author/workshop.hpp"
#include "command.hpp"
#include "image/compare.hpp"
#include "judge/compare/references.hpp"

using namespace atelier;
using namespace atelier::test;
using judge::JudgedCase;
using judge::Unit;
using nlohmann::json;

namespace {

/// Floats place a pixel's middle to about 1e-4 of a pixel, so of the pixels that an edge runs through one in ten
/// thousand falls on its other side, and more where a pattern is seen at a grazing angle. Three times what the worst
/// case shows: the hall at 178 degrees, 59 of 65536.
constexpr double share_at_edges = 0.003;

/// Where two edges meet within a pixel, its middle may see what no neighbour's middle sees: so many pixels of a picture
/// may be within no one-pixel shift of the truth. Most show none or one, the seams of fifteen spheres six.
constexpr int slivers = 8;

struct Compared {
  Measure measure = Measure::level;
  double delta = 1;    ///< in the measure's unit
  bool linear = true;  ///< linear colour, to be encoded
  double exposure = 1;
};

/// How close a reference must come away from edges. References are half floats: 11 bits.
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

/// The truth of these cases by name, from the step's program; what it refuses is left out. The program loads the
/// version's code, and does not ask it anything.
std::map<std::string, Image> truths(const Workshop& workshop, const Version& version, const std::vector<Case>& asks,
                                    int samples = 1) {
  const TemporaryFolder folder("atelier-truth-test");
  json cases = json::array();
  for (const Case& ask : asks) cases.push_back(to_json(ask));
  write_file(folder.path() / "cases.json", json{{"cases", cases}}.dump());
  const judge::RunSettings settings = workshop.settings(version);
  const Finished finished =
      run_process({.arguments = {settings.program.string(), "--truth", "--samples", std::to_string(samples), "--cases",
                                 (folder.path() / "cases.json").string(), "--out", folder.path().string(),
                                 "--implementations", settings.implementations.to_string()}});
  INFO(finished.output);
  REQUIRE(finished.ok());
  std::map<std::string, Image> traced;
  for (const Case& ask : asks)
    if (const auto file = folder.path() / (ask.name + ".pixels"); std::filesystem::exists(file))
      traced[ask.name] = read_pixels(file, ask.size);
  return traced;
}

Case showing(Case ask, const std::string& output) {
  ask.name += "-" + output;
  ask.output = output;
  return ask;
}

/// Pixels with an edge of the truth within one pixel: another thing, another surface behind it, another colour.
Mask near_edges(const std::string& name, const std::map<std::string, Image>& truth, const Compared& how) {
  const Image& shown = truth.at(name);
  const Image nothing(shown.width(), shown.height());  // the triangle has colours alone
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

struct Agreement {
  Difference strict, robust;
  int away_from_edges = 0;  ///< pixels that differ though no edge is near
  bool holds() const { return strict.share <= share_at_edges && robust.over <= slivers && away_from_edges == 0; }
};

/// `drawn` against the truth: each pixel equal to the truth's own, or, near an edge, within what the truth shows one
/// pixel around.
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

std::string in_words(const Agreement& a) {
  return fmt::format(
      "{} pixels differ ({:.3f} %), {} of them by more than a pixel's shift, {} away from edges; worst "
      "{:.2f} at {}, {}",
      a.strict.over, 100 * a.strict.share, a.robust.over, a.away_from_edges, a.strict.worst_distance, a.strict.worst.x,
      a.strict.worst.y);
}

std::vector<JudgedCase> pictures_of(const CourseStep& step) {
  auto cases = judge::read_case_file(folders().case_file(step.name)).cases;
  std::erase_if(cases, [](const JudgedCase& c) { return !c.ask.probe.empty(); });
  return cases;
}

/// Everything that `agreement` needs of these cases.
std::vector<Case> with_edges(const std::vector<Case>& asks) {
  std::vector<Case> all;
  for (const Case& ask : asks) {
    all.push_back(ask);
    for (const char* output : {"thing", "normal", "depth"}) all.push_back(showing(ask, output));
  }
  return all;
}

std::vector<Case> asks_of(const std::vector<JudgedCase>& cases) {
  std::vector<Case> asks;
  for (const JudgedCase& c : cases) asks.push_back(c.ask);
  return asks;
}

bool has_truth(const CourseStep& step) {
  return step.name != "00-hello";  // one line of GLSL, and no scene
}

double mean_level(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) {
    const Rgba &p = a.pixels()[i], &q = b.pixels()[i];
    sum += std::abs(p.r - q.r) + std::abs(p.g - q.g) + std::abs(p.b - q.b);
  }
  return 255 * sum / 3 / double(a.pixels().size());
}

}  // namespace

TEST_CASE("references are the ground truth, or say why they are not", "[truth][each-step]") {
  for (const CourseStep& step : course()) {
    if (!has_truth(step)) continue;
    const Workshop workshop(folders(), step);
    const Version solution = workshop.solution();
    REQUIRE(solution.built);
    const std::vector<JudgedCase> cases = pictures_of(step);
    const auto truth = truths(workshop, solution, with_edges(asks_of(cases)));
    const judge::StepReferences references(step.name, {}, folders().case_file(step.name).parent_path(), {});
    for (const JudgedCase& c : cases) {
      if (!truth.contains(c.ask.name)) {
        INFO(step.name << ", " << c.ask.name << ": the program has no truth for it");
        CHECK_FALSE(c.truth_differs.empty());
        continue;
      }
      const Agreement found = agreement(c.ask.name, references.of(c).pictures.at(0), truth, closeness(c));
      INFO(step.name << ", " << c.ask.name << ": " << in_words(found));
      if (c.truth_differs.empty())
        CHECK(found.holds());
      else
        CHECK_FALSE(found.holds());  // the reason is none: take the member away
    }
  }
}

TEST_CASE("the truth does not hang on the student's code", "[truth][each-step]") {
  for (const CourseStep& step : course()) {
    if (!has_truth(step)) continue;
    const Workshop workshop(folders(), step);
    const std::vector<Case> asks = asks_of(pictures_of(step));
    const Version solution = workshop.solution(), skeleton = workshop.skeleton();
    REQUIRE((solution.built && skeleton.built));
    CHECK(truths(workshop, solution, asks) == truths(workshop, skeleton, asks));
  }
}

TEST_CASE("mipmaps come close to what supersampling shows", "[truth][02-blinn-phong]") {
  const CourseStep* step = nullptr;
  const auto all = course();
  for (const CourseStep& each : all)
    if (each.name == "02-blinn-phong") step = &each;
  if (!step) SKIP_TEST("step 02 is not here");
  const Workshop workshop(folders(), *step);
  const Version solution = workshop.solution();
  REQUIRE(solution.built);

  std::vector<JudgedCase> cases = pictures_of(*step);
  std::erase_if(cases, [](const JudgedCase& c) { return c.truth_differs.find("ipmaps") == std::string::npos; });
  REQUIRE(cases.size() >= 4);
  const auto smooth = truths(workshop, solution, asks_of(cases), 8), sharp = truths(workshop, solution, asks_of(cases));
  const judge::StepReferences references(step->name, {}, folders().case_file(step->name).parent_path(), {});
  for (const JudgedCase& c : cases) {
    const auto compared = [&](const Image& image) { return as_compared(image, closeness(c)); };
    const Image reference = compared(references.of(c).pictures.at(0)), exact = compared(smooth.at(c.ask.name));
    if (c.ask.settings.contains("texture.decode")) continue;  // decoded late it is darker, mipmaps or not
    const double mipmapped = mean_level(reference, exact),
                 point_sampled = mean_level(compared(sharp.at(c.ask.name)), exact);
    INFO(c.ask.name << ": mean " << mipmapped << " of 255; without mipmaps " << point_sampled);
    CHECK(mipmapped < point_sampled);
  }

  // Without them the same pictures are the truth: geometry, coordinates, filtering, decoding and light are right.
  for (JudgedCase& c : cases) {
    c.ask.settings["texture.filter"] = std::string("linear");
    c.ask.settings.erase("texture.decode");
  }
  const auto exact = truths(workshop, solution, with_edges(asks_of(cases)));
  const auto drawn = judge::run_cases(workshop.settings(solution), asks_of(cases));
  for (std::size_t i = 0; i < cases.size(); ++i) {
    REQUIRE(drawn[i].pixels);
    const Agreement found = agreement(cases[i].ask.name, *drawn[i].pixels, exact, closeness(cases[i]));
    INFO(cases[i].ask.name << ", linear: " << in_words(found));
    CHECK(found.holds());
  }
}

TEST_CASE("every scene is the truth in every output, under every setting that must not matter", "[truth][each-step]") {
  struct Row {
    const char* name;
    const char* output;
    Compared how;
    std::map<std::string, SettingValue> settings;
  };
  // "triangle" has no outputs but its colour, which is a case. What is drawn comes here as whole floats. Depth is
  // reversed, so that slats and pairs are told apart (no pair's edge lies on a middle of 64 rows); the wall is as good
  // as round; textures are taken without mipmaps. "stretched" has two surfaces in one place, as its case says. In
  // "touching" a lamp lies in the floor: which side of it the floor hides is a matter of rounding.
  // "lantern" is full of shadows' edges at this size; its cases hold it against the truth at a larger one.
  const std::vector<Row> rows = {
      {"colour", "colour", {}, {}},
      {"normal", "normal", {Measure::degrees, 0.05, false}, {}},  // compare.hpp: angles are good to 0.02 degrees
      {"depth", "depth", {Measure::number, 1e-5, false}, {}},     // a float's depth, interpolated over large triangles
      {"usual-depth", "depth", {Measure::number, 1e-5, false}, {{"depth.format", std::string("32f")}}},
      {"position", "position", {Measure::number, 0.01, false}, {}},  // of scenes up to 10 km deep: 2^-20 of that
      {"from-the-eye", "position", {Measure::number, 0.01, false}, {{"world.camera_relative", true}}},
      {"texcoord", "texcoord", {Measure::number, 1e-3, false}, {}},
  };
  for (const CourseStep& step : course()) {
    if (!has_truth(step)) continue;
    const Workshop workshop(folders(), step);
    const Version solution = workshop.solution();
    REQUIRE(solution.built);
    const Finished listed =
        run_process({.arguments = {workshop.settings(solution).program.string(), "--list", "--json",
                                   "--implementations", workshop.settings(solution).implementations.to_string()}});
    REQUIRE(listed.ok());
    const json offers = json::parse(listed.output);
    std::set<std::string> settings;
    for (const json& setting : offers["settings"]) settings.insert(setting["name"]);
    for (const Row& row : rows) {
      const auto known = [&](const auto& setting) { return settings.contains(setting.first); };
      if (!std::all_of(row.settings.begin(), row.settings.end(), known)) continue;
      std::vector<Case> asks;
      for (const json& scene : offers["scenes"]) {
        if (scene == "triangle" || scene == "stretched") continue;
        if ((scene == "touching" || scene == "lantern") && row.output == std::string("colour")) continue;
        const bool asks_much_of_depth = scene == "slats" || scene == "depth-pairs";
        if (asks_much_of_depth && row.settings.contains("depth.format")) continue;
        Case& ask = asks.emplace_back(Case{.name = scene.get<std::string>() + "-" + row.name,
                                           .scene = scene,
                                           .size = {96, 64},
                                           .settings = row.settings,
                                           .output = row.output});
        if (settings.contains("texture.filter")) ask.settings["texture.filter"] = std::string("linear");
        if (settings.contains("depth.format")) ask.settings.try_emplace("depth.format", std::string("32f-reversed"));
        if (settings.contains("hall.segments")) ask.settings["hall.segments"] = 4096;
        // Texels of shadow maps far smaller than the pixels, so that the edges of shadows are where they should be.
        if (settings.contains("shadow.resolution")) ask.settings["shadow.resolution"] = 4096;
        if (settings.contains("shadow.fit")) ask.settings["shadow.fit"] = std::string("casters");
        if (settings.contains("cube.resolution")) ask.settings["cube.resolution"] = 3072;
      }
      const auto truth = truths(workshop, solution, with_edges(asks));
      const auto drawn = judge::run_cases(workshop.settings(solution), asks);
      for (std::size_t i = 0; i < asks.size(); ++i) {
        INFO(step.name << ", " << asks[i].name << " " << drawn[i].error);
        REQUIRE(drawn[i].pixels);
        const Agreement found = agreement(asks[i].name, *drawn[i].pixels, truth, row.how);
        INFO(in_words(found));
        CHECK(found.holds());
      }
    }
  }
}
