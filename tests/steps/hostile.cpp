// Whoever hands in an attack reaches nothing, leaves nothing behind, and changes nobody's grade. The submissions are in
// tests/hostile; its README.md says how to add one, and how to run a few of them.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <set>

#include "base/file.hpp"
#include "catch.hpp"
#include "command.hpp"
#include "hostile_canary.hpp"
#include "hostile_submissions.hpp"

using namespace atelier;
using namespace atelier::test;
using nlohmann::json;

namespace fs = std::filesystem;

namespace {

const std::string honest_name = "an-honest-one";

/// Those of a half, or those that ATELIER_HOSTILE names, with commas between them.
std::vector<HostileSubmission> chosen_submissions(bool fast) {
  std::vector<HostileSubmission> all = read_hostile_submissions();
  const char* names = std::getenv("ATELIER_HOSTILE");
  const std::string list = names ? "," + std::string(names) + "," : "";
  std::erase_if(all, [&](const HostileSubmission& s) {
    return names ? list.find("," + s.name + ",") == list.npos : fast && !s.fast;
  });
  return all;
}

/// All that must not depend on the company in which a submission is graded.
json judged_alike(const json& results) {
  json kept = json::array();
  for (const json& step : results.at("steps")) {
    kept.push_back({step["step"], step["score"], step["max_score"], step["build_log"], step["caveat"]});
    for (const json& c : step["cases"])
      kept.push_back({c["name"], c["status"], c["score"], c["max_score"], c["reason"], c["mistake"], c["figures"]});
  }
  return kept;
}

json results_in(const fs::path& folder) {
  INFO(folder.string());
  REQUIRE(fs::exists(folder / "results.json"));
  return json::parse(read_file(folder / "results.json"));
}

/// The sandbox in which a submission has run; empty: the results do not say.
std::string tier_in(const fs::path& folder) {
  if (fs::exists(folder / "record.json")) return json::parse(read_file(folder / "record.json")).value("sandbox", "");
  return results_in(folder).at("environment").value("sandbox", "");
}

void check_hostile(bool fast) {
  const std::vector<HostileSubmission> submissions = chosen_submissions(fast);
  REQUIRE(!submissions.empty());
  Canary canary;
  const TemporaryFolder work("atelier-steps-test");
  const fs::path students = work.path() / "class", alone = work.path() / "alone", out = work.path() / "out";
  std::set<std::string> steps;
  for (const HostileSubmission& s : submissions) {
    write_hostile_submission(s, students / s.name);
    steps.insert(s.step);
  }
  for (const std::string& step : steps)
    write_honest_submission(step, students / honest_name, honest_mark + " " + canary.honest());

  const Finished quiet = canary.grade({(students / honest_name).string(), "--out", alone.string()});
  INFO(quiet.output);
  REQUIRE(quiet.exit_status == 0);
  const json expected = judged_alike(results_in(alone));
  // Nothing hostile runs by surprise where nothing contains it.
  if (tier_in(alone) == "none" && !std::getenv("ATELIER_HOSTILE_SANDBOX"))
    SKIP_TEST("this machine has no sandbox: ./atelier doctor says why");

  std::vector<std::string> arguments = {students.string(), "--out", out.string()};
  for (const std::string& step : steps) arguments.insert(arguments.end(), {"--step", step});
  const Finished finished = canary.grade(arguments);
  INFO(finished.output);
  REQUIRE(!finished.timed_out);
  REQUIRE(finished.exit_status == 0);
  const fs::path honest = out / "students" / honest_name;
  CHECK(judged_alike(results_in(honest)) == expected);
  for (const std::string& sentence : canary.found_changed()) FAIL_CHECK(sentence);
  CHECK(finished.output.find(canary.secret()) == std::string::npos);
  CHECK(finished.output.find(hostile_success) == std::string::npos);
  CHECK(finished.output.find('\x1b') == std::string::npos);

  const std::string tier = tier_in(honest);
  for (const HostileSubmission& s : submissions) {
    if (s.needs_full && tier == "account") continue;
    const fs::path folder = out / "students" / s.name;
    INFO(s.name << ": " << s.tries);
    if (!fs::exists(folder / "results.json")) {
      FAIL_CHECK("it has no results");
      continue;
    }
    for (const std::string& sentence :
         found_in_results(s, results_in(folder), folder, {canary.secret(), canary.honest()}))
      FAIL_CHECK(s.name << ": " << sentence);
    CHECK(fs::exists(folder / "report.html"));
    // No case of it has run in another sandbox than the honest one's.
    CHECK(tier_in(folder) == tier);
  }
  for (const char* file : {"gradebook.csv", "class.html"}) {
    INFO(file);
    const std::string bytes = read_file(out / file);
    for (const std::string& word : {canary.secret(), canary.honest(), hostile_success})
      CHECK(bytes.find(word) == std::string::npos);
    CHECK(!live_text(file, bytes));
  }
}

}  // namespace

TEST_CASE("every folder of tests/hostile is listed, and every listed one is there", "[hostile][hostile-all]") {
  std::set<std::string> listed, there;
  for (const HostileSubmission& s : read_hostile_submissions()) {
    INFO(s.name);
    CHECK(listed.insert(s.name).second);
    CHECK(!s.threat.empty());
    CHECK(s.tries.ends_with("."));
    CHECK(s.at_most >= 0);
    CHECK(s.at_most <= 1);
    const TemporaryFolder folder;
    write_hostile_submission(s, folder.path());
  }
  for (const auto& entry : fs::directory_iterator(folders().root / "tests" / "hostile"))
    if (entry.is_directory()) there.insert(entry.path().filename().string());
  CHECK(listed == there);
}

TEST_CASE("hostile submissions reach nothing and leave nothing: the fast half", "[hostile]") {
  check_hostile(true);
}

TEST_CASE("hostile submissions reach nothing and leave nothing: all of them", "[hostile-all]") {
  check_hostile(false);
}
