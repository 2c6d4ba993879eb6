// A class is graded whole: again without work, in part where something has changed, and whatever happens to a process.
#include <signal.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "made_class.hpp"
#include "running.hpp"

using namespace atelier;
using namespace atelier::test;
using nlohmann::json;

namespace {

namespace fs = std::filesystem;

/// What is printed by a run that must end with this status.
std::string run(const MadeClass& made, const fs::path& out, const std::vector<std::string>& more = {}, int status = 0) {
  Running grader(made.command(out, more), made.environment());
  const int ended = grader.wait();
  INFO(grader.output());
  REQUIRE(ended == status);
  return grader.output();
}

json record_of(const fs::path& out, const std::string& student) {
  return json::parse(read_file(out / "students" / student / "record.json"));
}

/// The students whose reports are not those of `before`.
std::vector<std::string> graded_again(const fs::path& out, std::map<std::string, std::string>& before) {
  std::vector<std::string> again;
  for (const std::string& student : MadeClass::students()) {
    const std::string now = stamp_of_graded(out, student).value_or("");
    if (std::exchange(before[student], now) != now) again.push_back(student);
  }
  return again;
}

}  // namespace

TEST_CASE("a class is graded once, and again where something has changed", "[class]") {
  const MadeClass made;
  const fs::path out = made.place("out");
  std::map<std::string, std::string> stamps;

  CHECK(mentions(run(made, out), {"6 submissions: 6 graded", "0 kept from before", "a person: see", "gradebook.csv"}));
  CHECK(graded_again(out, stamps) == MadeClass::students());
  const auto verdict = class_verdicts(out);
  CHECK(mentions(verdict.at("gradebook.csv"), {"ada,ada,0,100,100", "cy,cy,,0,0", "bob,bob,,100,100"}));
  CHECK(mentions(verdict.at("students/cy"), {"could not be built", "build_failed"}));
  CHECK(mentions(verdict.at("students/fay"), {"passed", "failed"}));
  for (const char* file : {"class.html", "class.json", "junit.xml", "gradebook.csv"})
    CHECK(mentions(read_file(out / file), {"ada", "bob", "cy", "dan", "eve", "fay"}));
  CHECK(leavings(made, out) == std::vector<std::string>{});

  CHECK(mentions(run(made, out), {"6 submissions: 0 graded", "6 kept from before"}));
  CHECK(graded_again(out, stamps).empty());
  CHECK(class_verdicts(out) == verdict);

  made.change("dan");
  CHECK(mentions(run(made, out), {"1 graded", "5 kept from before"}));
  CHECK(graded_again(out, stamps) == std::vector<std::string>{"dan"});

  write_file(out / "students" / "eve" / "record.json", "{\"schema\": 1, ");
  run(made, out);
  CHECK(graded_again(out, stamps) == std::vector<std::string>{"eve"});
  CHECK(class_verdicts(out) == verdict);

  run(made, out, {"--step", "00"});  // all are graded, for this step alone; the other stays as it was
  CHECK(graded_again(out, stamps) == MadeClass::students());
  CHECK(class_verdicts(out).at("gradebook.csv") == verdict.at("gradebook.csv"));
  for (const std::string& student : MadeClass::students()) {
    const json record = record_of(out, student);
    REQUIRE(record["steps"].size() == 2);
    CHECK(record["steps"][1]["step"] == "01-transforms");
  }
}

TEST_CASE("a submission on which the grader itself ends twice is left to a person", "[class]") {
  const MadeClass made;
  const fs::path out = made.place("out"), undisturbed = made.place("undisturbed");
  run(made, undisturbed);
  run(made, out);  // so that there is an old report, which must not stay
  made.change("bob");

  Running grader(made.command(out, {"--workers", "1"}), made.environment());
  for (int end = 0; end < 2; ++end) {
    const fs::path at_work = out / "state" / "worker-0";
    pid_t worker = 0;
    REQUIRE(comes_true([&] {
      const std::vector<pid_t> children = grader.children();
      if (children.size() != 1 || !fs::exists(at_work)) return false;
      worker = children.front();
      return read_file(at_work) == "bob";
    }));
    ::kill(worker, SIGKILL);
    // The file is of the process that was killed until the grader has noticed.
    REQUIRE(comes_true([&] { return !fs::exists(at_work) || grader.children() != std::vector<pid_t>{worker}; }));
    REQUIRE(comes_true([&] { return !fs::exists(at_work); }));
  }
  CHECK(grader.wait() == 0);
  const auto expected = class_verdicts(undisturbed);
  for (const auto& [file, verdict] : class_verdicts(out))
    if (file == "students/bob")
      CHECK(mentions(verdict, {"The grader itself has ended 2 times on it", "SIGKILL"}));
    else if (file != "gradebook.csv")
      CHECK(verdict == expected.at(file));
  CHECK_FALSE(fs::exists(out / "students" / "bob" / "report.html"));
  CHECK(mentions(read_file(out / "gradebook.csv"), {"bob"}));
  CHECK(leavings(made, out) == std::vector<std::string>{});

  CHECK(mentions(run(made, out), {"1 graded", "5 kept from before"}));  // what had no verdict is tried again
  CHECK(class_verdicts(out) == expected);
}

TEST_CASE("two graders do not share a folder of results, and one that cannot be written is refused", "[class]") {
  const MadeClass made;
  const fs::path out = made.place("out");
  Running first(made.command(out), made.environment());
  REQUIRE(comes_true([&] { return fs::exists(out / "state" / "plan.cbor"); }));
  CHECK(mentions(run(made, out, {}, 2), {"error: --out", "another process grades into this folder"}));
  CHECK(first.wait() == 0);
  CHECK(leavings(made, out) == std::vector<std::string>{});

  write_file(made.place("file"), "");
  CHECK(mentions(run(made, made.place("file") / "out", {}, 2), {"error: --out", "name a writable folder"}));
  CHECK(mentions(run(made, "/proc/out", {}, 2), {"error: --out /proc/out", "name a writable folder"}));
}

TEST_CASE("a grader that is stopped by Ctrl-C leaves what is graded, and nothing else", "[class]") {
  const MadeClass made;
  const fs::path out = made.place("out");
  Running grader(made.command(out, {"--workers", "1"}), made.environment());
  REQUIRE(comes_true([&] { return stamp_of_graded(out, "ada").has_value(); }));
  grader.signal(SIGINT);
  CHECK(grader.wait() == -SIGINT);
  CHECK_FALSE(fs::exists(out / "gradebook.csv"));
  const auto stamp = stamp_of_graded(out, "ada");
  run(made, out);
  CHECK(stamp_of_graded(out, "ada") == stamp);
  CHECK(leavings(made, out) == std::vector<std::string>{});
}
