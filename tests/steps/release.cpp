// A release contains nothing that students must find out, works alone, and its submissions can be graded.
#include <algorithm>

#include "base/file.hpp"
#include "catch.hpp"
#include "cli/author/marked_text.hpp"
#include "cli/grader/release_leaks.hpp"
#include "command.hpp"
#include "judge/compare/judged_case.hpp"

using namespace atelier;
using namespace atelier::test;
namespace fs = std::filesystem;

namespace {

/// Every file below a folder.
grade::PackedFiles files_below(const fs::path& folder) {
  grade::PackedFiles files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      files[fs::relative(entry.path(), folder).generic_string()].bytes = read_file(entry.path());
  return files;
}

/// What may not be in a release, as FILE: WHAT.
std::vector<std::string> secrets_in(const grade::PackedFiles& files) {
  std::vector<std::string> found;
  for (const Leak& leak : find_leaks(files, distinctive_lines(folders(), course(), course())))
    found.push_back(leak.file + ": " + leak.line);
  std::vector<std::string> hidden;
  for (const CourseStep& step : course())
    for (const auto& c : judge::read_case_file(folders().case_file(step.name)).cases)
      if (c.hidden) hidden.push_back(c.ask.name);
  for (const auto& [name, file] : files) {
    if (name.ends_with(".patch") || name.starts_with("solutions/")) found.push_back(name);
    if (!name.starts_with("common/") && file.bytes.find(".patch\"") != std::string::npos)
      found.push_back(name + ": a patch's name");
    for (const std::string& c : hidden)
      if (name.find("/" + c + ".") != name.npos || name.find("/" + c + "--") != name.npos ||
          file.bytes.find('"' + c + '"') != std::string::npos)
        found.push_back(name + ": the hidden case " + c);
  }
  return found;
}

}  // namespace

TEST_CASE("a release of the course contains no line of a solution, no patch and no hidden case", "[release]") {
  const TemporaryFolder temporary;
  const fs::path out = temporary.path() / "course";
  const Finished finished = run_atelier({"release", "all", "--out", out.string()});
  INFO(finished.output);
  REQUIRE(finished.exit_status == 0);
  CHECK(mentions(finished.output, {"files", "points", "patches", "hidden cases"}));
  grade::PackedFiles files = files_below(out);
  CHECK(secrets_in(files).empty());

  CHECK(distinctive_lines(folders(), course(), course()).size() > 100);
  for (const CourseStep& step : course())
    for (const std::string& file : step.files) {
      INFO(step.name << "/" << file);
      CHECK_FALSE(files.contains("steps/" + step.name + "/" + file));
      CHECK(files.contains("skeletons/" + step.name + "/" + file));
    }
  CHECK((fs::status(out / "atelier").permissions() & fs::perms::owner_exec) != fs::perms::none);

  // The search can fail: what a slip would let through is found.
  const std::string marked = read_file(folders().solutions() / "01-transforms" / "transforms.cpp");
  std::string line;
  for (const std::string& candidate : solution_lines(marked, "transforms.cpp"))
    if (candidate.size() > line.size()) line = candidate;
  const std::pair<const char*, std::string> slips[] = {
      {"README.md", "Write this:\n\n    " + line + "\n"},
      {"skeletons/01-transforms/transforms.cpp", marked},
      {"tests/mistakes/01-transforms/axis.patch", "--- a/transforms.cpp\n"},
      {"solutions/00-hello/hello.glsl", "x"},
      {"tests/mistakes/00-hello/mistakes.json", R"([{"patch": "red-and-blue.patch"}])"},
  };
  for (const auto& [name, text] : slips) {
    INFO(name);
    grade::PackedFiles leaky = files;
    leaky[name].bytes = text;
    CHECK_FALSE(secrets_in(leaky).empty());
  }
}

TEST_CASE("a release as a ZIP equals the release as a folder, and is the same each time", "[release]") {
  const TemporaryFolder temporary;
  const auto path = [&](const char* name) { return (temporary.path() / name).string(); };
  for (const char* name : {"one.zip", "two.zip", "folder"})
    REQUIRE(run_atelier({"release", "01", "--out", path(name)}).exit_status == 0);
  CHECK(read_file(path("one.zip")) == read_file(path("two.zip")));
  fs::create_directory(path("unpacked"));
  REQUIRE(run_process({.arguments = {"cmake", "-E", "tar", "xf", path("one.zip")}, .folder = path("unpacked")}).ok());
  const grade::PackedFiles unpacked = files_below(path("unpacked")), folder = files_below(path("folder"));
  REQUIRE(unpacked.size() == folder.size());
  for (const auto& [name, file] : folder) {
    INFO(name);
    CHECK(unpacked.at(name).bytes == file.bytes);
  }
}

TEST_CASE("a release that cannot be made leaves nothing behind", "[release]") {
  const TemporaryFolder temporary;
  const fs::path full = temporary.path() / "full";
  write_file(full / "mine.txt", std::string_view("my own"));
  struct Row {
    const char* name;
    std::vector<std::string> arguments;
    const char* says;
  };
  const std::string out = (temporary.path() / "out").string();
  const Row rows[] = {
      {"a folder that is not empty", {"release", "00", "--out", full.string()}, "not empty"},
      {"a file", {"release", "00", "--out", (full / "mine.txt").string()}, "is a file"},
      {"below a file", {"release", "00", "--out", (full / "mine.txt" / "out").string()}, "mine.txt"},
      {"no earlier step", {"release", "all", "--out", out, "--earlier", "source"}, "use no other"},
      {"an unknown step", {"release", "99", "--out", out}, "99"},
      {"nowhere to go", {"release", "00"}, "--out"},
      {"an unknown choice", {"release", "02", "--out", out, "--earlier", "mine"}, "--earlier"},
      {"no ZIP", {"submit", "00", "--out", out}, ".zip"},
  };
  for (const Row& row : rows) {
    const Finished finished = run_atelier(row.arguments);
    INFO(row.name << ": " << finished.output);
    CHECK(finished.exit_status == 2);
    CHECK(mentions(finished.output, {row.says}));
    CHECK(!fs::exists(out));
    CHECK(files_below(temporary.path()).size() == 1);
  }
}

TEST_CASE("a packed submission is graded like its files", "[release]") {
  const TemporaryFolder temporary;
  const fs::path zip = temporary.path() / "01.zip";
  const Finished finished = run_atelier({"submit", "01", "--out", zip.string()});
  INFO(finished.output);
  REQUIRE(finished.exit_status == 0);
  for (const CourseStep& step : course()) {
    if (step.number() != "01") continue;
    for (const std::string& file : step.files) CHECK(mentions(finished.output, {step.name + "/" + file}));
  }
  nlohmann::json packed = graded(zip)["steps"], loose = graded(folders().steps(), {"--step", "01"})["steps"];
  REQUIRE(packed.size() == 1);
  CHECK(packed[0]["score"] == loose[0]["score"]);
  CHECK(packed[0]["build_log"] == loose[0]["build_log"]);
  REQUIRE(packed[0]["cases"].size() == loose[0]["cases"].size());
  for (std::size_t i = 0; i < packed[0]["cases"].size(); ++i)
    CHECK(packed[0]["cases"][i]["status"] == loose[0]["cases"][i]["status"]);
}

TEST_CASE("a release works without the repository", "[release-builds]") {
  const TemporaryFolder temporary;
  const fs::path out = temporary.path() / "course";
  REQUIRE(run_atelier({"release", "all", "--out", out.string()}).exit_status == 0);
  const auto launch = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"env", "-u", "ATELIER_BUILD", (out / "atelier").string(), "--yes"});
    return run_process({.arguments = arguments, .folder = out, .time_limit = std::chrono::minutes(50)});
  };
  const Finished first = launch({"check", "00-hello"});
  INFO(first.output);
  REQUIRE(first.exit_status == 1);  // the skeleton, judged
  CHECK(mentions(first.output, {"steps/00-hello/hello.glsl is new: write it", "triangle"}));

  fs::copy_file(folders().solutions() / "00-hello" / "hello.glsl", out / "steps" / "00-hello" / "hello.glsl",
                fs::copy_options::overwrite_existing);
  const Finished second = launch({"check", "00-hello"});
  INFO(second.output);
  CHECK(second.exit_status == 0);
  CHECK(launch({"submit", "00"}).exit_status == 0);
  CHECK(fs::exists(out / "out" / "submit" / "00-hello.zip"));
  CHECK(launch({"list"}).exit_status == 0);
  CHECK(mentions(launch({"test"}).output, {"a release has no tests"}));
}
