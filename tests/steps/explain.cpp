// ./atelier explain finds the first intermediate that differs, at the pixel that check names.
#include <sstream>

#include "base/file.hpp"
#include "catch.hpp"
#include "command.hpp"

using namespace atelier;
using namespace atelier::test;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

/// A student's work folder with the solution of step 02, changed by a known mistake.
class Work {
 public:
  explicit Work(const std::string& mistake) {
    const fs::path step = folder_.path() / "steps" / "02-blinn-phong";
    fs::create_directories(step.parent_path());
    fs::copy(folders().solutions() / "02-blinn-phong", step);
    const fs::path patch = folders().mistakes() / "02-blinn-phong" / (mistake + ".patch");
    const Finished patched =
        run_process({.arguments = {"/usr/bin/env", "patch", "-p1", "-d", step.string(), "-i", patch.string()}});
    INFO(patched.output);
    REQUIRE(patched.ok());
  }

  Finished run(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"/usr/bin/env", "ATELIER_WORK=" + folder_.path().string(),
                                         (folders().build / "bin" / "atelier").string()});
    return run_process({.arguments = arguments, .folder = folders().root});
  }

 private:
  TemporaryFolder folder_;
};

std::vector<std::string> arguments_in(const std::string& line) {
  std::vector<std::string> words;
  std::istringstream stream(line);
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

}  // namespace

TEST_CASE("a wrong highlight is found before the colour that it makes wrong", "[explain][02-blinn-phong]") {
  const Work work("rv-for-nh");
  const Finished checked = work.run({"check", "02", "--case", "backlight", "--skip-report"});
  INFO(checked.output);
  const std::string command = "./atelier explain 02 backlight --pixel ";
  const auto at = checked.output.find(command);
  REQUIRE(at != std::string::npos);
  std::vector<std::string> arguments = arguments_in(checked.output.substr(at, checked.output.find('\n', at) - at));
  arguments.erase(arguments.begin());

  const Finished text = work.run(arguments);
  INFO(text.output);
  CHECK(text.exit_status == 1);
  CHECK(mentions(text.output, {"The output 'specular' is the first to differ: yours is off by"}));

  arguments.push_back("--json");
  const Finished printed = work.run(arguments);
  INFO(printed.output);
  const json found = json::parse(printed.output);
  CHECK(found["first"] == "specular");
  CHECK(found["functions"] == json{"reflected", "highlight"});
  CHECK(found["visible"] == "surface");
  std::vector<std::string> outputs, differing;
  for (const json& row : found["outputs"]) {
    outputs.push_back(row["output"]);
    CHECK(row["beside"] == "solution");
    if (row["differs"] == true) differing.push_back(row["output"]);
  }
  CHECK(outputs ==
        std::vector<std::string>{"position", "depth", "texcoord", "normal", "diffuse", "specular", "colour"});
  CHECK(differing == std::vector<std::string>{"specular", "colour"});

  const Finished elsewhere = work.run({"explain", "02", "backlight", "--pixel", "0,0"});
  INFO(elsewhere.output);
  CHECK(elsewhere.exit_status == 0);
  CHECK(mentions(elsewhere.output, {"Nothing differs at this pixel. The picture differs most at " + arguments[4]}));
}
