#include "grade/results/record.hpp"

#include <nlohmann/json.hpp>

#include "base/file.hpp"
#include "catch.hpp"
#include "class_sample.hpp"

using namespace atelier;
using namespace atelier::grade;
using atelier::test::error_of;
using atelier::test::mentions;

TEST_CASE("a record is read back as it was written") {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "record.json";
  SubmissionRecord record = test::ada();
  record.late = true;
  record.needs_human = {"Two files have the same name."};
  record.notes = {"notes", ""};
  record.key = "abc";
  record.seed = 0xFFFF'FFFF'FFFF'FFFFULL;
  record.steps.push_back({.step = "03-shadow-mapping", .state = StepRecord::State::not_built});
  record.steps[0].tiers["challenge"] = {0.1 + 0.2, 3};
  for (const bool known : {true, false}) {
    if (!known) record.handed_in.reset();
    write_file(file, to_json_text(record));
    const SubmissionRecord read = read_record(file);
    CHECK(to_json_text(read) == to_json_text(record));
    CHECK(read.handed_in == record.handed_in);
    CHECK(read.seed == record.seed);
    CHECK(read.steps[0].tiers == record.steps[0].tiers);
    CHECK(read.steps[1].mistakes == record.steps[1].mistakes);
    CHECK(read.steps[2].state == StepRecord::State::not_built);
    CHECK(read.late);
  }
}

TEST_CASE("a record counts the cases with points, tiers and mistakes of a judged step") {
  using judge::Status;
  judge::StepResult step{.step = "02-blinn-phong", .score = 3, .max_score = 6};
  const auto add = [&](Status status, double score, double max_score, const char* tier) {
    judge::CaseResult c;
    c.status = status, c.score = score, c.max_score = max_score, c.tier = tier;
    if (status == Status::failed) c.mistake = "rv-for-nh";
    step.cases.push_back(c);
  };
  add(Status::passed, 2, 2, "core");
  add(Status::passed, 0, 0, "core");
  add(Status::failed, 1, 2, "further");
  add(Status::failed, 0, 2, "further");
  const StepRecord record = record_of(step, StepRecord::State::judged);
  CHECK(record.passed == 1);
  CHECK(record.cases == 3);
  CHECK(record.tiers == std::map<std::string, TierPoints>{{"core", {2, 2}}, {"further", {1, 4}}});
  CHECK(record.mistakes == std::map<std::string, int>{{"rv-for-nh", 2}});
  CHECK(record_of(step, StepRecord::State::untouched).mistakes.empty());
}

TEST_CASE("a damaged record is refused, naming the file and the member") {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "record.json";
  const std::string good = to_json_text(test::ada());
  struct Row {
    const char *member, *value, *says;
  };
  const Row rows[] = {{"schema", "2", "schema"},
                      {"late", "1", "late"},
                      {"student", "{}", "id"},
                      {"student", R"({"id": "../x", "name": "", "identifier": ""})", "id: \"../x\" is not allowed"},
                      {"student", R"({"id": "", "name": "", "identifier": ""})", "id: \"\" is not allowed"},
                      {"source", R"("a\u001b[2J")", "source"},
                      {"handed_in", "1.5", "handed_in"},
                      {"handed_in", "1e300", "handed_in"},
                      {"handed_in", "9223372036854775807", "handed_in"},
                      {"steps", "[{}]", "steps[0]: member 'step'"},
                      {"steps", "{}", "steps: {} is not allowed"},
                      {"steps",
                       R"([{"step": "a", "state": "judged", "score": 0, "max_score": 0, "tiers": {}, "passed": 0,
                            "cases": 0, "mistakes": {"../x": 1}}])",
                       "mistakes: \"../x\" is not allowed"},
                      {"seed", "-1", "seed"},
                      {"seconds", R"({"compile": -1})", "seconds: compile"},
                      {"notes", "[1]", "notes"},
                      {"extra", "1", "unknown member 'extra'"}};
  for (const Row& row : rows) {
    INFO(row.member << ": " << row.value);
    nlohmann::json document = nlohmann::json::parse(good);
    document[row.member] = nlohmann::json::parse(row.value);
    write_file(file, document.dump());
    CHECK(mentions(error_of([&] { read_record(file); }), {"record.json", row.says}));
  }
  for (std::size_t length = 0; length < good.size() - 1; length += 7) {
    write_file(file, good.substr(0, length));
    CHECK(mentions(error_of([&] { read_record(file); }), {"record.json"}));
  }
  for (const char* member : {"state", "score", "tiers", "passed", "mistakes"}) {
    nlohmann::json document = nlohmann::json::parse(good);
    document["steps"][1][member] = "wrong";
    write_file(file, document.dump());
    CHECK(mentions(error_of([&] { read_record(file); }), {"record.json: steps[1]: ", member}));
  }
}
