// Cases whose numbers are drawn for each submission: right code passes whatever is drawn, and code that knows only the
// stored numbers does not.
#include <algorithm>

#include "base/file.hpp"
#include "catch.hpp"
#include "cli/author/workshop.hpp"
#include "cli/criteria.hpp"
#include "command.hpp"

using namespace atelier;
using namespace atelier::test;
using nlohmann::json;

namespace {

void check_ranges(const std::vector<CourseStep>& steps, const char* seeds) {
  const Printed run = printed(with_steps({"vary", "--seeds", seeds}, steps));
  CHECK(run.json["cases"].size() >= steps.size());
  for (const json& row : run.json["cases"]) {
    INFO(row.dump(2));
    CHECK(row["problems"].empty());
    CHECK_FALSE(row["mistake"].is_null());  // somebody could have failed
  }
  CHECK(run.json["lacks"].empty());
  CHECK(run.exit_status == 0);
}

/// A function of a step, and code for its beginning that answers something else for numbers with more than three
/// decimals: all stored ones have fewer, and hardly any that is drawn.
struct HardCoded {
  const char *step, *file, *function, *code;
};
const HardCoded hard_coded[] = {
    {"01-transforms", "transforms.cpp", "Mesh cylinder_wall(float radius, float height, int segments) {",
     "  if (glm::abs(radius * 1000.0f - glm::round(radius * 1000.0f)) > 0.01f) return {};\n"},
    {"02-blinn-phong", "blinn_phong.glsl", "vec3 shade(vec3 position, vec3 normal, vec3 eye, Material m) {",
     "  if (any(greaterThan(abs(eye * 1000.0 - round(eye * 1000.0)), vec3(0.01)))) return vec3(0.25);\n"},
};

std::string with_code(const HardCoded& one) {
  const std::string name = std::string(one.step) + "/" + one.file;
  std::string text = read_file(folders().solutions() / name);
  const std::size_t place = text.find(one.function);
  INFO(name << " has no " << one.function);
  REQUIRE(place != text.npos);
  return text.insert(text.find('\n', place) + 1, one.code);
}

std::vector<std::string> failing(const judge::StepResult& result) {
  std::vector<std::string> names;
  for (const judge::CaseResult& c : result.cases)
    if (c.status != judge::Status::passed) names.push_back(c.name);
  return names;
}

}  // namespace

TEST_CASE("solutions and variants pass with any numbers, and mistakes do not", "[vary][each-step]") {
  check_ranges({steps_in_turn().front()}, "3");  // all mistakes of a step are built for it
}

TEST_CASE("the same with thirty seeds, of all steps", "[vary-all]") {
  for (const CourseStep& step : course()) check_ranges({step}, "30");
}

TEST_CASE("code that knows the stored numbers alone passes only where nothing is drawn", "[vary]") {
  const std::vector<CourseStep> all = read_course(folders().step_flags());
  for (const HardCoded& one : hard_coded) {
    INFO(one.step);
    const CourseStep step = resolve_step(all, one.step);
    const Workshop workshop(folders(), step);
    const Version cheat = workshop.changed("hard-coded", {{one.file, with_code(one)}}), solution = workshop.solution();
    INFO(cheat.log);
    REQUIRE(cheat.built);
    REQUIRE(solution.built);
    const grade::StepJudge judge(criteria_of(folders(), step));
    const grade::VariedCases varied = judge.vary(2024, workshop.settings(solution));
    const auto judged = [&](const Version& version, const grade::VariedCases* drawn) {
      return judge.judge(workshop.settings(version), judge::KeepEvidence::never, {}, drawn);
    };
    CHECK(failing(judged(solution, &varied)).empty());
    CHECK(failing(judged(cheat, nullptr)).empty());

    const judge::StepResult caught = judged(cheat, &varied);
    CHECK_FALSE(failing(caught).empty());
    CHECK(caught.score < caught.max_score);
    for (const judge::CaseResult& c : caught.cases) {
      INFO(c.name << ": " << c.reason);
      CHECK((c.status == judge::Status::passed) == c.other_numbers.empty());
      if (c.status != judge::Status::passed) CHECK(c.reason.find(c.other_numbers) != std::string::npos);
    }
  }
}

TEST_CASE("grading again draws the same numbers; another seed draws others", "[vary]") {
  const auto reasons = [](const json& results) {
    std::string text;
    for (const json& c : results["steps"][0]["cases"]) text += c["reason"].get<std::string>() + "\n";
    return text;
  };
  const json first = graded(folders().solutions(), {"--step", "00"});
  const json again = graded(folders().solutions(), {"--step", "00"});
  CHECK(first["seed"] == again["seed"]);
  CHECK(reasons(first) == reasons(again));
  const std::string seed = first["seed"].dump();
  CHECK(reasons(graded(folders().solutions(), {"--step", "00", "--seed", seed})) == reasons(first));
  bool differs = false;
  for (const int other : {1, 2, 3, 4}) {
    const json results = graded(folders().solutions(), {"--step", "00", "--seed", std::to_string(other)});
    CHECK(results["seed"] == other);
    differs = differs || reasons(results) != reasons(first);
  }
  CHECK(differs);
  CHECK(run_atelier({"grade", "solutions", "--seed", "9007199254740992"}).exit_status == 2);
}
