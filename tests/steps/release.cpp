// A release contains nothing that students must find out, works alone, and its submissions can be graded.
#include <algorithm>
#include <map>
#include <regex>
#include <set>

#include "base/file.hpp"
#include "base/sealed.hpp"
#include "catch.hpp"
#include "cli/author/marked_text.hpp"
#include "cli/commands.hpp"
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

constexpr const char* elf = "\177ELF";  // how a library begins

/// Whether a file of solutions/ is in no readable form: a library without debug information, or a sealed shader.
bool is_unreadable(const std::string& name, const std::string& bytes) {
  if (name.ends_with(".glsl")) return is_sealed(bytes);
  return name.ends_with("/libstep.so") && bytes.starts_with(elf) && bytes.find(".debug_") == bytes.npos &&
         bytes.find(folders().root.string()) == bytes.npos;
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
    if (name.ends_with(".patch")) found.push_back(name);
    if (name.starts_with("solutions/") && !is_unreadable(name, file.bytes)) found.push_back(name + ": can be read");
    if (!name.starts_with("common/") && file.bytes.find(".patch\"") != std::string::npos)
      found.push_back(name + ": a patch's name");
    for (const std::string& c : hidden)
      if (name.find("/" + c + ".") != name.npos || name.find("/" + c + "--") != name.npos ||
          file.bytes.find('"' + c + '"') != std::string::npos)
        found.push_back(name + ": the hidden case " + c);
  }
  return found;
}

/// What the pattern's group holds at each of its places in the text.
std::set<std::string> found_in(const std::string& text, const std::regex& pattern) {
  std::set<std::string> found;
  for (std::sregex_iterator at(text.begin(), text.end(), pattern), end; at != end; ++at) found.insert((*at)[1]);
  return found;
}

std::set<std::string> commands_in(const std::string& text) {
  static const std::regex command(R"(\./atelier ([a-z][a-z-]*))");
  return found_in(text, command);
}

/// Whether a release has the command: it exists, and needs nothing that a release lacks.
bool is_command_of_release(const std::string& command) {
  static std::map<std::string, bool> known = {{"help", true}};  // the launcher's own
  const auto [entry, is_new] = known.emplace(command, false);
  if (is_new)
    entry->second =
        std::find(std::begin(for_whole_project), std::end(for_whole_project), command) == std::end(for_whole_project) &&
        run_atelier({command, "--help"}).exit_status == 0;
  return entry->second;
}

/// Where a text for students leads nowhere, as FILE: WHAT: a link to a file that is not packed, a given file of a
/// handout's step that is not, a command that a release does not have.
std::vector<std::string> dead_ends(const grade::PackedFiles& files) {
  static const std::regex link(R"(\]\(([^)#\s]+)[^)]*\))");
  std::vector<std::string> found;
  for (const auto& [name, file] : files) {
    const bool page = name.ends_with(".md");
    const bool contract = name.starts_with("skeletons/") || (name.starts_with("steps/") && name.ends_with(".hpp"));
    if (!page && !contract && !name.starts_with("tests/")) continue;
    if (page || contract || name.ends_with(".json"))
      for (const std::string& command : commands_in(file.bytes))
        if (!is_command_of_release(command)) found.push_back(name + ": ./atelier " + command);
    if (!page) continue;
    static const std::regex given("`(given/[a-z_]+\\.[a-z]+)`");
    for (const std::string& mentioned : found_in(file.bytes, given))
      if (!files.contains("steps/" + fs::path(name).stem().string() + "/" + mentioned))
        found.push_back(name + ": " + mentioned);
    for (const std::string& target : found_in(file.bytes, link)) {
      if (target.starts_with("https://")) continue;
      const fs::path path = (fs::path(name).parent_path() / target).lexically_normal();
      if (!files.contains(path.generic_string())) found.push_back(name + ": " + target);
    }
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
  CHECK(secrets_in(files) == std::vector<std::string>{});

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
      {"solutions/01-transforms/libstep.so", elf + folders().root.string()},
      {"tests/mistakes/00-hello/mistakes.json", R"([{"patch": "red-and-blue.patch"}])"},
  };
  for (const auto& [name, text] : slips) {
    INFO(name);
    grade::PackedFiles leaky = files;
    leaky[name].bytes = text;
    CHECK_FALSE(secrets_in(leaky).empty());
  }
}

TEST_CASE("what a release has for its readers leads somewhere", "[release]") {
  const TemporaryFolder temporary;
  grade::PackedFiles whole;
  for (const char* steps : {"all", "05"}) {
    const fs::path out = temporary.path() / steps;
    REQUIRE(run_atelier({"release", steps, "--out", out.string(), "--earlier", "none"}).exit_status == 0);
    whole = files_below(out);
    INFO(steps);
    CHECK(dead_ends(whole) == std::vector<std::string>{});

    const Finished help = run_process({.arguments = {(out / "atelier").string(), "help"}, .folder = out});
    REQUIRE(help.ok());
    CHECK(commands_in(help.output).contains("check"));
    for (const std::string& command : commands_in(help.output)) {
      INFO(command);
      CHECK(is_command_of_release(command));
    }
    for (const char* left_out : {"solutions", "authors"}) CHECK_FALSE(mentions(help.output, {left_out}));
  }
  // The walk finds what leads nowhere.
  for (const char* text : {"[docs](docs/platforms.md)", "[home](../README.md#top)", "./atelier audit 01",
                           "./atelier chekc", "`given/x.cpp`"}) {
    INFO(text);
    whole["README.md"].bytes = text;
    CHECK(dead_ends(whole).size() == 1);
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
      {"no earlier step", {"release", "all", "--out", out, "--earlier", "source"}, "use no step that is not released"},
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

  for (const char* command : for_whole_project) {
    const Finished refused = launch({command});
    INFO(refused.output);
    CHECK(refused.exit_status == 2);
    CHECK(mentions(refused.output, {command, "a release has no tests and no solutions to read", "./atelier help"}));
  }

  // Right files of 02 beside an untouched 01: its compiled solution stands in.
  const fs::path own = out / "steps" / "02-blinn-phong";
  for (const char* file : {"blinn_phong.cpp", "blinn_phong.glsl", "choices.txt"})
    fs::copy_file(folders().solutions() / "02-blinn-phong" / file, own / file, fs::copy_options::overwrite_existing);
  const Finished right = launch({"check", "02"});
  INFO(right.output);
  CHECK(right.exit_status == 0);
  CHECK(mentions(right.output, {"with 01-transforms: solution"}));

  // Nobody can hand it in.
  const fs::path sealed = out / "solutions" / "01-transforms" / "transforms.glsl",
                 mine = out / "steps" / "01-transforms";
  fs::copy_file(sealed, mine / "transforms.glsl", fs::copy_options::overwrite_existing);
  CHECK(mentions(launch({"check", "01"}).output, {"transforms.glsl", "sealed part of a solution"}));
  CHECK(launch({"reset", "01/transforms.glsl", "--force"}).exit_status == 0);

  // Without it the verdict begins with what to do first.
  fs::remove_all(out / "solutions");
  const Finished alone = launch({"check", "02"});
  INFO(alone.output);
  CHECK(alone.exit_status == 1);
  CHECK(alone.output.starts_with("02-blinn-phong uses earlier files of yours that do not pass in full: 01-transforms"));
  CHECK(mentions(alone.output, {"(untouched)", "./atelier check 01", "with 01-transforms: yours, untouched"}));
  CHECK(mentions(launch({"check", "02", "--earlier", "solution"}).output,
                 {"error: --earlier solution", "01-transforms"}));
}
