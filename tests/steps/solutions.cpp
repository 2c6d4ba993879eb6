// The solutions get all points, and the result files are as documented.
#include "base/file.hpp"
#include "catch.hpp"
#include "command.hpp"

using namespace atelier;
using namespace atelier::test;
using nlohmann::json;

TEST_CASE("the solutions get all points", "[solutions][each-step]") {
  const json results = graded(folders().solutions());
  REQUIRE(results["steps"].size() == course().size());
  CHECK(results["score"] == results["max_score"]);
  for (const json& step : results["steps"]) {
    CHECK(step["build_log"] == "");
    CHECK(!step["cases"].empty());
    for (const json& c : step["cases"]) {
      INFO(step["step"].get<std::string>()
           << " " << c["name"].get<std::string>() << ": " << c["reason"].get<std::string>());
      CHECK(c["status"] == "passed");
      CHECK(c["score"] == c["max_score"]);
    }
  }
}

TEST_CASE("grading writes three files that agree", "[solutions]") {
  const TemporaryFolder out;
  const Finished finished = run_atelier({"grade", "solutions", "--step", "00", "--out", out.path().string()});
  REQUIRE(finished.exit_status == 0);
  const json results = json::parse(read_file(out.path() / "results.json"));
  for (const char* member : {"submission", "score", "max_score", "steps", "environment"})
    CHECK(results.contains(member));
  for (const char* member : {"driver", "context", "compiler", "cpu"}) {
    INFO(member);
    CHECK(!results["environment"][member].get<std::string>().empty());
  }
  const json& c = results["steps"][0]["cases"][0];
  for (const char* member : {"name", "title", "status", "score", "max_score", "reason", "mistake", "hint"}) {
    INFO(member);
    CHECK(c.contains(member));
  }
  const std::string name = c["name"];
  CHECK(read_file(out.path() / "junit.xml").find(name) != std::string::npos);
  CHECK(read_file(out.path() / "report.html").find(name) != std::string::npos);
}

TEST_CASE("a step that was not submitted is missing if requested, and otherwise absent", "[solutions]") {
  const TemporaryFolder submission;
  std::filesystem::copy(folders().solutions() / "00-hello", submission.path() / "00-hello");
  CHECK(graded(submission.path())["steps"].size() == 1);
  const json results = graded(submission.path(), {"--step", "00", "--step", "01"});
  REQUIRE(results["steps"].size() == 2);
  for (const json& c : results["steps"][1]["cases"]) {
    CHECK(c["status"] == "missing");
    CHECK(c["score"] == 0);
  }
}

TEST_CASE("a missing file and a file that does not compile cost only that step", "[solutions]") {
  const TemporaryFolder submission;
  for (const char* step : {"00-hello", "01-transforms", "02-blinn-phong"})
    std::filesystem::copy(folders().solutions() / step, submission.path() / step);
  std::filesystem::remove(submission.path() / "02-blinn-phong" / "blinn_phong.glsl");
  write_file(submission.path() / "01-transforms" / "transforms.cpp", std::string_view("this is no C++\n"));
  const json results = graded(submission.path());
  REQUIRE(results["steps"].size() == 3);
  for (const json& c : results["steps"][0]["cases"]) CHECK(c["status"] == "passed");
  const char* const statuses[] = {"passed", "build_failed", "missing"};
  for (int broken : {1, 2}) {
    CHECK(results["steps"][broken]["score"] == 0);
    for (const json& c : results["steps"][broken]["cases"]) CHECK(c["status"] == statuses[broken]);
  }
  CHECK(results["steps"][2]["build_log"] == "");
  CHECK(results["steps"][1]["build_log"].get<std::string>().find("transforms.cpp:1") != std::string::npos);
  CHECK(results["steps"][2]["cases"][0]["reason"].get<std::string>().find("blinn_phong.glsl") != std::string::npos);
}
