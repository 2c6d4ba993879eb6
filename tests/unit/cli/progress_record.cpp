#include "cli/student/progress_record.hpp"

#include "base/file.hpp"
#include "catch.hpp"

using namespace atelier;
using atelier::test::error_of;
using atelier::test::mentions;
using judge::Status;

namespace {

judge::StepResult result_of(Status a, Status b, double score) {
  judge::StepResult result{.step = "01-move", .score = score, .max_score = 10};
  result.cases.push_back({.name = "a", .status = a});
  result.cases.push_back({.name = "b", .status = b});
  return result;
}

const std::string digest(64, 'a');

}  // namespace

TEST_CASE("a missing record is empty, and a written one is read back") {
  const TemporaryFolder folder;
  const auto file = folder.path() / "progress.json";
  CHECK(read_progress(file).empty());

  ProgressRecord record;
  judge::StepResult failed = result_of(Status::passed, Status::failed, 4.25);
  failed.causes.push_back({.kind = judge::Cause::Kind::function, .functions = {"turn"}, .shown = {1}});
  record_check(record, failed, digest);
  raise_hint_level(record, "01-move", "b", 2);
  raise_hint_level(record, "99-from-a-later-course", "x", 1);
  write_progress(file, record);
  const ProgressRecord again = read_progress(file);
  REQUIRE(again.size() == 2);
  const StepProgress& step = again.at("01-move");
  REQUIRE(step.check);
  CHECK(step.check->score == 4.25);
  CHECK(step.check->max_score == 10);
  CHECK(step.check->files == digest);
  CHECK(step.check->cases == std::map<std::string, bool>{{"a", true}, {"b", false}});
  CHECK(step.check->passed() == 1);
  CHECK(step.check->begin_with == "b");
  CHECK(step.check->wrong_function == "turn");
  CHECK(step.check->when.size() == std::string("2025-03-01T09:30:00Z").size());
  CHECK(step.best == 4.25);
  CHECK(hint_level(again, "01-move", "b") == 2);
  CHECK(!again.at("99-from-a-later-course").check);
}

TEST_CASE("a record keeps the name of every function of the course") {
  for (const char* name : {"turn", "make_preview", "u", "srgbEncode", "shadow_factor_0"}) {
    INFO(name);
    const TemporaryFolder folder;
    ProgressRecord record;
    judge::StepResult failed = result_of(Status::passed, Status::failed, 4);
    failed.causes.push_back({.kind = judge::Cause::Kind::function, .functions = {name}, .shown = {1}});
    record_check(record, failed, digest);
    write_progress(folder.path() / "progress.json", record);
    CHECK(read_progress(folder.path() / "progress.json").at("01-move").check->wrong_function == name);
  }
}

TEST_CASE("a check replaces the previous one; the best score and the hints stay") {
  ProgressRecord record;
  record_check(record, result_of(Status::passed, Status::passed, 10), digest);
  raise_hint_level(record, "01-move", "a", 3);
  record_check(record, result_of(Status::passed, Status::crashed, 6), digest);
  CHECK(record.at("01-move").check->score == 6);
  CHECK(record.at("01-move").best == 10);
  CHECK(hint_level(record, "01-move", "a") == 3);
}

TEST_CASE("hint levels rise and never fall") {
  ProgressRecord record;
  CHECK(hint_level(record, "01-move", "a") == 0);
  raise_hint_level(record, "01-move", "a", 2);
  raise_hint_level(record, "01-move", "a", 1);
  CHECK(hint_level(record, "01-move", "a") == 2);
  CHECK(hint_level(record, "01-move", "b") == 0);
}

TEST_CASE("a pass counts only for the judged files, and for all current cases of the step") {
  const TemporaryFolder folder;
  const std::vector<std::string> files = {"move.cpp", "move.glsl"};
  write_file(folder.path() / "move.cpp", std::string_view("int a;\n"));
  const std::string missing = digest_of_files(folder.path(), files);
  write_file(folder.path() / "move.glsl", std::string_view(""));
  const std::string judged = digest_of_files(folder.path(), files);
  CHECK(judged != missing);

  ProgressRecord record;
  record_check(record, result_of(Status::passed, Status::passed, 10), judged);
  const StepProgress& step = record.at("01-move");
  CHECK(has_passed(step, {"a", "b"}, judged));
  CHECK(!has_passed(step, {"a", "b", "new-in-an-update"}, judged));
  CHECK(!has_passed({}, {"a"}, judged));

  write_file(folder.path() / "move.cpp", std::string_view("int b;\n"));
  CHECK(!has_passed(step, {"a", "b"}, digest_of_files(folder.path(), files)));
  write_file(folder.path() / "move.cpp", std::string_view("int a;\n"));  // as it was, only younger
  CHECK(has_passed(step, {"a", "b"}, digest_of_files(folder.path(), files)));

  record_check(record, result_of(Status::passed, Status::timeout, 5), judged);
  CHECK(!has_passed(record.at("01-move"), {"a", "b"}, judged));
}

TEST_CASE("a broken record is refused with the file, the member and a fix") {
  const TemporaryFolder folder;
  const auto file = folder.path() / "progress.json";
  struct Row {
    const char *name, *text, *says;
  };
  const Row rows[] = {
      {"cut off", R"({"schema": 1, "steps": {)", "parse error"},
      {"no object", "[1]", "object"},
      {"another schema", R"({"schema": 2, "steps": {}})", "schema"},
      {"no steps", R"({"schema": 1})", "steps"},
      {"an unknown member", R"({"schema": 1, "steps": {"01-move": {"hint": {}}}})", "'hints'"},
      {"a level that is none", R"({"schema": 1, "steps": {"01-move": {"hints": {"a": 4}}}})", "1..3"},
      {"a digest that is none",
       R"({"schema": 1, "steps": {"01-move": {"check": {"when": "now", "score": 1, "max_score": 1, "files": "abc",
           "cases": {}}}}})",
       "SHA-256"},
      {"a case that is a number",
       R"({"schema": 1, "steps": {"01-move": {"check": {"when": "now", "score": 1, "max_score": 1, "files":
           "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa", "cases": {"a": 1}}}}})",
       "true or false"},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    write_file(file, std::string_view(row.text));
    CHECK(mentions(error_of([&] { read_progress(file); }), {"progress.json", row.says, "move it away"}));
  }
}
