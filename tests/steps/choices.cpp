// Budget cases through the command: the student's choice, counted with the solution's code.
#include "base/file.hpp"
#include "catch.hpp"
#include "command.hpp"

using namespace atelier;
using namespace atelier::test;
using nlohmann::json;

namespace {

const json& case_named(const json& results, const std::string& name) {
  for (const json& step : results["steps"])
    for (const json& c : step["cases"])
      if (c["name"] == name) return c;
  FAIL("no case " + name);
  return results;
}

}  // namespace

TEST_CASE("a choice is judged independently of the student's code", "[choices]") {
  const TemporaryFolder submission;
  const auto copy = [&](const char* from, const char* step, const char* file) {
    const auto to = submission.path() / step;
    std::filesystem::create_directories(to);
    std::filesystem::copy_file(folders().root / from / step / file, to / file,
                               std::filesystem::copy_options::overwrite_existing);
  };
  // Untouched skeletons, which draw nothing, beside a finished choice: the solution draws what is chosen.
  for (const char* file : {"transforms.cpp", "transforms.glsl"}) copy("steps", "01-transforms", file);
  copy("solutions", "01-transforms", "choices.txt");
  const json chosen = graded(submission.path());
  CHECK(case_named(chosen, "hall-choice")["status"] == "passed");
  CHECK(case_named(chosen, "hall")["status"] != "passed");

  // And the other way round.
  for (const char* file : {"transforms.cpp", "transforms.glsl"}) copy("solutions", "01-transforms", file);
  write_file(submission.path() / "01-transforms/choices.txt", std::string_view("hall-choice: hall.segments = 4096\n"));
  const json dear = graded(submission.path());
  CHECK(case_named(dear, "hall")["status"] == "passed");
  CHECK(case_named(dear, "hall-choice")["status"] == "failed");
  CHECK(case_named(dear, "hall-choice")["score"] == 0);
  CHECK(case_named(dear, "hall-choice")["reason"].get<std::string>().find("at most 200 are allowed") !=
        std::string::npos);

  // What cannot be read as choices costs its own cases alone.
  struct Row {
    const char* text;
    const char* says;
  };
  for (const Row& row : {Row{"\x1b[2J\n", "choices.txt:1"}, Row{"hall-choice: hall.segments = \xff\n", "choices.txt:1"},
                         Row{"hall-choice: hall.segments = nan\n", "'nan' is not allowed"},
                         Row{"hall-choise: hall.segments = 96\n", "did you mean 'hall-choice'"}}) {
    INFO(row.says);
    write_file(submission.path() / "01-transforms/choices.txt", std::string_view(row.text));
    const json broken = graded(submission.path());
    CHECK(case_named(broken, "hall")["status"] == "passed");
    CHECK(case_named(broken, "hall-choice")["status"] == "missing");
    CHECK(case_named(broken, "hall-choice")["reason"].get<std::string>().find(row.says) != std::string::npos);
  }
}
