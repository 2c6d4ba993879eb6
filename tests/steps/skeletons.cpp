// The skeletons: made from the solutions, working, and without points.
#include <map>

#include "catch.hpp"
#include "command.hpp"
#include "judge/compare/judged_case.hpp"

using namespace atelier;
using namespace atelier::test;
using nlohmann::json;

TEST_CASE("the skeletons match the solutions", "[skeletons][each-step]") {
  const Finished finished = run_atelier(with_steps({"skeleton", "--check"}));
  INFO(finished.output);
  CHECK(finished.exit_status == 0);
}

TEST_CASE("untouched skeletons build without a warning, do not crash, and earn nothing", "[skeletons][each-step]") {
  const json results = graded(folders().steps());
  REQUIRE(results["steps"].size() == course().size());
  for (const json& step : results["steps"]) {
    const std::string name = step["step"];
    INFO(name);
    CHECK(step["build_log"] == "");
    std::map<std::string, bool> student;  // whether a case is meant for a student to earn
    for (const auto& c : judge::read_case_file(folders().case_file(name)).cases) student[c.ask.name] = c.student;
    for (const json& c : step["cases"]) {
      const std::string status = c["status"];
      INFO(c["name"].get<std::string>() << " " << status << ": " << c["reason"].get<std::string>());
      CHECK(status != "crashed");
      CHECK(status != "timeout");
      if (student.at(c["name"])) {
        CHECK(status != "passed");
        CHECK((c["score"] == 0 || c["score"] < c["max_score"]));
      }
    }
  }
}
