// ./atelier grade --cases: a grader's own cases, which the solution answers.
#include <regex>

#include "base/file.hpp"
#include "catch.hpp"
#include "command.hpp"
#include "judge/run/build.hpp"

using namespace atelier;
using namespace atelier::test;

namespace {

/// The example of the guide, so that it is right.
std::string example() {
  const std::string guide = read_file(folders().root / "docs" / "grading.md");
  const std::size_t begin = guide.find("```json\n") + 8;
  return guide.substr(begin, guide.find("```", begin) - begin);
}

nlohmann::json case_named(const nlohmann::json& results, const std::string& name) {
  for (const nlohmann::json& c : results["steps"][0]["cases"])
    if (c["name"] == name) return c;
  return {};
}

}  // namespace

TEST_CASE("a grader's own cases are answered by the solution, and count", "[further-cases]") {
  const TemporaryFolder folder;
  const std::string step = "02-blinn-phong";
  write_file(folder.path() / "cases" / step / "cases.json", example());
  const std::vector<std::string> options = {"--step", step, "--cases", (folder.path() / "cases").string()};

  const nlohmann::json usual = graded(folders().solutions(), {"--step", step});
  const nlohmann::json solved = graded(folders().solutions(), options);
  CHECK(solved["max_score"] == usual["max_score"].get<double>() + 5);
  CHECK(solved["score"] == solved["max_score"]);
  CHECK(case_named(solved, "secret-encode")["status"] == "passed");

  const std::filesystem::path wrong = folder.path() / "wrong";
  judge::take_step_files(judge::read_step_flags(folders().step_flags()), step, folders().solutions() / step,
                         wrong / step);
  const std::string text = read_file(wrong / step / "blinn_phong.cpp");
  write_file(wrong / step / "blinn_phong.cpp", std::regex_replace(text, std::regex("2\\.4f"), "2.2f"));
  CHECK(case_named(graded(wrong, options), "secret-encode")["status"] == "failed");
}

TEST_CASE("further cases that cannot be judged are refused before anything is graded", "[further-cases]") {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "02-blinn-phong" / "cases.json";
  const auto refused = [&] {
    const Finished run = run_atelier({"grade", folders().solutions().string(), "--step", "02", "--out",
                                      (folder.path() / "out").string(), "--cases", folder.path().string()});
    CHECK(run.exit_status == 2);
    CHECK(!std::filesystem::exists(folder.path() / "out"));
    return run.output;
  };
  CHECK(mentions(refused(), {"has no cases", "00-hello"}));
  write_file(file, std::regex_replace(example(), std::regex("secret-encode"), "srgb-encode"));
  CHECK(mentions(refused(), {"case 'srgb-encode': the step has one too"}));
  write_file(file, std::regex_replace(example(), std::regex("02-blinn-phong"), "03-shadow-mapping"));
  CHECK(mentions(refused(), {"'03-shadow-mapping' is not '02-blinn-phong'"}));
  write_file(file, std::regex_replace(example(), std::regex("\"probe\": \"srgb_encode\""), "\"probe\": \"no_probe\""));
  CHECK(mentions(refused(), {"secret-encode", "does not answer"}));
}
