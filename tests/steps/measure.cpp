// The measurements of every setting agree with theory, and the handouts' plots show current numbers. No time is
// asserted on.
#include <filesystem>
#include <sstream>

#include "base/file.hpp"
#include "catch.hpp"
#include "command.hpp"
#include "measure/tables.hpp"

using namespace atelier;
using namespace atelier::test;
using nlohmann::json;

namespace {

/// Those in turn that say what is to be measured.
std::vector<CourseStep> measured_steps() {
  std::vector<CourseStep> steps;
  for (const CourseStep& step : steps_in_turn())
    if (std::filesystem::exists(folders().measure_file(step.name))) steps.push_back(step);
  return steps;
}

/// The fields of a line, between commas.
std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> words;
  std::istringstream text(line);
  for (std::string word; std::getline(text, word, ',');) words.push_back(word);
  return words;
}

/// The errors of a sweep among all that were measured, laid out like the numbers of a handout's plot: under the same
/// head, curve, value and error.
std::string like_a_plot(const std::string& measured, const std::string& sweep, const std::string& plot) {
  std::string text = plot.substr(0, plot.find('\n') + 1);
  std::istringstream lines(measured);
  for (std::string line; std::getline(lines, line);)
    if (const std::vector<std::string> words = fields_of(line); words.at(0) == sweep)
      text += words.at(1) + "," + words.at(2) + "," + words.at(4) + "\n";
  return text;
}

}  // namespace

TEST_CASE("slopes, orders and values are what theory expects", "[measure][each-step]") {
  if (is_whole_course()) REQUIRE(measured_steps().size() >= 2);  // only step 00 has nothing to measure
  for (const CourseStep& step : measured_steps()) {
    const TemporaryFolder out;
    const Printed run = printed({"measure", step.name, "--frames", "1", "--out", out.path().string()});
    INFO(step.name);
    CHECK(run.exit_status == 0);
    for (const json& sweep : run.json["sweeps"]) {
      INFO(sweep["name"].get<std::string>());
      for (const json& finding : sweep["findings"]) {
        INFO(finding["words"].get<std::string>());
        CHECK(finding["met"].get<bool>());
      }
      for (const json& point : sweep["points"]) {
        CHECK(point["frames"]["count"] == 1);
        CHECK(point["counts"]["target_bytes"].get<double>() > 0);
      }
    }
    for (const json& front : run.json["fronts"]) CHECK(!front["knee"].is_null());
    CHECK(std::filesystem::exists(out.path() / "index.html"));
    // The handouts' plots show the same numbers.
    const std::string measured = read_file(out.path() / "measure.csv");
    for (const auto& plot : std::filesystem::directory_iterator(folders().handouts() / "plots")) {
      const std::string name = plot.path().stem().string();
      if (plot.path().extension() != ".csv" || !name.starts_with(step.number() + "-")) continue;
      INFO(name);
      const std::string stored = read_file(plot.path());
      CHECK(measure::difference(like_a_plot(measured, name.substr(3), stored), stored) == "");
    }
  }
}

TEST_CASE("every plot of a handout is shown in it, and every shown plot exists", "[measure][each-step]") {
  for (const CourseStep& step : measured_steps()) {
    const std::string handout = read_file(folders().handouts() / (step.name + ".md"));
    for (const auto& entry : std::filesystem::directory_iterator(folders().handouts() / "plots")) {
      const std::string file = entry.path().filename().string();
      if (!file.starts_with(step.number() + "-") || entry.path().extension() != ".svg") continue;
      INFO("handouts/plots/" << file << " is not shown in the handout: show it, or delete it and its .csv");
      const bool shown = handout.find("](plots/" + file + ")") != std::string::npos;
      CHECK(shown);
    }
    for (std::size_t at = 0; (at = handout.find("](plots/", at)) != std::string::npos; ++at) {
      const std::string file = handout.substr(at + 2, handout.find(')', at) - at - 2);
      INFO(file);
      CHECK(std::filesystem::exists(folders().handouts() / file));
    }
  }
}

TEST_CASE("invalid measurements are refused before anything is drawn", "[measure]") {
  struct Row {
    const char* name;
    std::vector<std::string> arguments;
    std::initializer_list<std::string_view> words;
  };
  const Row rows[] = {
      {"a step without a plan", {"measure", "00"}, {"00-hello", "measure.json", "missing"}},
      {"an unknown setting", {"measure", "01", "--setting", "hall.segment"}, {"did you mean 'hall.segments'"}},
      {"one that is no approximation", {"measure", "01", "--setting", "draw.wireframe"}, {"not measured"}},
      {"no frame", {"measure", "01", "--frames", "0"}, {"--frames"}},
      {"a check of nothing", {"measure", "01", "--check"}, {"--handout"}},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    const Finished run = run_atelier(row.arguments);
    INFO(run.output);
    CHECK(run.exit_status == 2);
    CHECK(mentions(run.output, row.words));
  }
}
