// Live references, drawn by the solution, work on any driver. The other driver here is Mesa's softpipe, whose
// rasteriser shares no code with llvmpipe's.
#include <algorithm>

#include "catch.hpp"
#include "cli/author/workshop.hpp"
#include "cli/criteria.hpp"
#include "command.hpp"

using namespace atelier;
using namespace atelier::test;

namespace {

/// softpipe takes its time. Edges, curved surfaces, textures, highlights.
const std::vector<std::string>& few_cases(const std::string& step) {
  static const std::vector<std::string> none, of_01 = {"robot", "hall", "spiral", "texcoords"},
                                              of_02 = {"sphere", "tiles", "spots", "facets"};
  return step == "01-transforms" ? of_01 : step == "02-blinn-phong" ? of_02 : none;
}

int passed(const judge::StepResult& result) {
  return int(std::count_if(result.cases.begin(), result.cases.end(),
                           [](const auto& c) { return c.status == judge::Status::passed; }));
}

}  // namespace

TEST_CASE("live references work on a driver that draws differently", "[live]") {
  int stored_passed = 0, asked = 0;
  for (const CourseStep& step : course()) {
    const std::vector<std::string>& names = few_cases(step.name);
    if (names.empty()) continue;
    INFO(step.name);
    const Workshop workshop(folders(), step);
    const Version solution = workshop.solution(), skeleton = workshop.skeleton();
    REQUIRE(solution.built);
    REQUIRE(skeleton.built);
    const auto by_softpipe = [&](const Version& version) {
      judge::RunSettings settings = workshop.settings(version);
      settings.environment["GALLIUM_DRIVER"] = "softpipe";
      settings.workers = 2;
      return settings;
    };
    grade::StepJudge judge(criteria_of(folders(), step), names);
    asked += int(names.size());
    const judge::StepResult stored = judge.judge(by_softpipe(solution));
    stored_passed += passed(stored);
    CHECK(stored.references == "stored");

    judge.use_live_references(by_softpipe(solution));
    const judge::StepResult live = judge.judge(by_softpipe(solution));
    CHECK(live.references == "live");
    CHECK(passed(live) == int(names.size()));
    CHECK(passed(judge.judge(by_softpipe(skeleton))) == 0);
    // The reference is what this driver draws, and not what another one does.
    CHECK(passed(judge.judge(workshop.settings(solution))) == passed(stored));
  }
  CHECK(asked == 8);
  CHECK(stored_passed < asked);  // or the two drivers would not differ, and nothing above be shown
}
