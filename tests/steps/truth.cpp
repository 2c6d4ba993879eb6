// The references against the ground truth: the solution's pictures equal the oracle's, except for rounding at edges and
// for cases with truth_differs.
#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "base/file.hpp"
#include "catch.hpp"
#include "cli/author/truth_agreement.hpp"
#include "command.hpp"
#include "judge/compare/references.hpp"

using namespace atelier;
using namespace atelier::test;
using judge::JudgedCase;
using nlohmann::json;

namespace {

double mean_level(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) {
    const Rgba &p = a.pixels()[i], &q = b.pixels()[i];
    sum += std::abs(p.r - q.r) + std::abs(p.g - q.g) + std::abs(p.b - q.b);
  }
  return 255 * sum / 3 / double(a.pixels().size());
}

}  // namespace

TEST_CASE("references are the ground truth, or have a reason why not", "[truth][each-step]") {
  for (const CourseStep& step : steps_in_turn()) {
    const Workshop workshop(folders(), step);
    const Version solution = workshop.solution(), skeleton = workshop.skeleton();
    REQUIRE((solution.built && skeleton.built));
    const std::vector<JudgedCase> cases = pictures_of(folders(), step);
    const auto truth = truths(workshop, solution, with_edges(asks_of(cases)));
    for (const auto& [name, picture] : truths(workshop, skeleton, asks_of(cases))) {
      INFO(step.name << ", " << name << ": the truth depends on the student's code");
      CHECK(picture == truth.at(name));
    }
    const judge::StepReferences references(step.name, {}, judge::references_folder(folders().case_file(step.name)), {});
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

TEST_CASE("mipmaps approximate supersampling", "[truth][02-blinn-phong]") {
  const CourseStep* step = nullptr;
  const auto all = course();
  for (const CourseStep& each : all)
    if (each.name == "02-blinn-phong") step = &each;
  if (!step) SKIP_TEST("step 02 is not here");
  const Workshop workshop(folders(), *step);
  const Version solution = workshop.solution();
  REQUIRE(solution.built);

  std::vector<JudgedCase> cases = pictures_of(folders(), *step);
  std::erase_if(cases, [](const JudgedCase& c) { return c.truth_differs.find("ipmaps") == std::string::npos; });
  REQUIRE(cases.size() >= 4);
  const auto smooth = truths(workshop, solution, asks_of(cases), 8), sharp = truths(workshop, solution, asks_of(cases));
  const judge::StepReferences references(step->name, {}, judge::references_folder(folders().case_file(step->name)), {});
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

TEST_CASE("every output of every scene is the truth, under every setting without effect", "[truth][each-step]") {
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
  // "lantern" and "lamp" are full of shadows' edges at this size; their cases are held against the truth at a larger
  // one. On the round "column" a march is an approximation, however fine: `./atelier measure 06` says how good.
  const std::vector<Row> rows = {
      {"colour", "colour", {}, {}},
      {"normal", "normal", {Measure::degrees, 0.05, false}, {}},  // compare.hpp: angles are good to 0.02 degrees
      {"depth", "depth", {Measure::number, 1e-5, false}, {}},     // a float's depth, interpolated over large triangles
      {"usual-depth", "depth", {Measure::number, 1e-5, false}, {{"depth.format", std::string("32f")}}},
      {"position", "position", {Measure::number, 0.01, false}, {}},  // of scenes up to 10 km deep: 2^-20 of that
      {"from-the-eye", "position", {Measure::number, 0.01, false}, {{"world.camera_relative", true}}},
      {"texcoord", "texcoord", {Measure::number, 1e-3, false}, {}},
  };
  std::set<std::pair<std::string, std::string>> traced;  // positions, depths ... of a scene are the same in each step
  for (const CourseStep& step : steps_in_turn()) {
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
        if (scene == "triangle" || scene == "stretched" || scene == "column") continue;
        const bool shaded_finely = scene == "touching" || scene == "lantern" || scene == "lamp";
        if (shaded_finely && row.output == std::string("colour")) continue;
        const bool asks_much_of_depth = scene == "slats" || scene == "depth-pairs";
        if (asks_much_of_depth && row.settings.contains("depth.format")) continue;
        if (row.output != std::string("colour") && !traced.insert({row.name, scene}).second) continue;
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
        // Previews are pictures, with mipmaps: their cases are held against the truth where these do not matter.
        if (settings.contains("preview.most")) ask.settings["preview.most"] = 0;
        // Reliefs as exact as they get, also in the depth buffer.
        if (settings.contains("parallax.method")) {
          ask.settings["parallax.method"] = std::string("relief");
          ask.settings["parallax.layers"] = 256;
          ask.settings["parallax.bisections"] = 10;
          ask.settings["parallax.write_depth"] = true;
        }
      }
      if (asks.empty()) continue;  // no scene is traced
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
