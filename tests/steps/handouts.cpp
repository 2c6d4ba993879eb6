// Everything that a handout names exists: the files and headings of its links, the cases of its tables, and the scenes,
// settings and outputs of its commands. It names every case, and the points are right.
#include <algorithm>
#include <regex>
#include <set>
#include <sstream>

#include "base/file.hpp"
#include "catch.hpp"
#include "cli/author/step_rules.hpp"
#include "command.hpp"
#include "editor_tasks.hpp"
#include "judge/compare/judged_case.hpp"

using namespace atelier;
using namespace atelier::test;
using nlohmann::json;

namespace {

using Names = std::set<std::string>;

/// The steps that have cases.
std::vector<CourseStep> judged_steps() {
  std::vector<CourseStep> steps = course();
  std::erase_if(steps, [](const CourseStep& step) { return !std::filesystem::exists(folders().case_file(step.name)); });
  return steps;
}

std::string handout_of(const CourseStep& step) {
  return read_file(folders().handouts() / (step.name + ".md"));
}

/// What the pattern's group holds at each of its places in the text.
Names found(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  Names names;
  for (std::sregex_iterator at(text.begin(), text.end(), regex), end; at != end; ++at) names.insert((*at)[1]);
  return names;
}

/// What stands in the last column of tables whose last heading is "Cases", between backquotes.
Names cases_in_tables(const std::string& handout) {
  Names names;
  bool within = false;
  std::istringstream lines(handout);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with('|')) {
      within = false;
    } else if (line.ends_with("| Cases |")) {
      within = true;
    } else if (within) {
      const std::size_t begin = line.find_last_of('|', line.size() - 2);
      names.merge(found(line.substr(begin), "`([^` ]+)`"));
    }
  }
  return names;
}

/// The anchors of a text's headings: in small letters, blanks as dashes, without punctuation.
Names anchors_of(const std::string& text) {
  Names anchors;
  for (const std::string& heading : found(text, "(?:^|\n)#+ ([^\n]+)")) {
    std::string anchor;
    for (const char c : heading)
      if (std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_')
        anchor += char(std::tolower(static_cast<unsigned char>(c)));
      else if (c == ' ')
        anchor += '-';
    anchors.insert(anchor);
  }
  return anchors;
}

/// The names in a list of what a program has, or the list itself where it holds nothing but names.
Names names_in(const json& list) {
  Names names;
  for (const json& entry : list) names.insert(entry.is_string() ? entry : entry["name"]);
  return names;
}

/// Those of `these` that are none of `those`, for a message.
std::string missing(const Names& these, const Names& those) {
  std::string names;
  for (const std::string& name : these)
    if (!those.contains(name)) names += name + ' ';
  return names;
}

/// What `PROGRAM --list --json` prints.
json listing_of(const CourseStep& step) {
  const std::string whose = (folders().implementations() / "solutions").string() + ":" + folders().solutions().string();
  const Finished run = run_process(
      {.arguments = {folders().program(step.name).string(), "--implementations", whose, "--list", "--json"}});
  return json::parse(run.output);
}

}  // namespace

TEST_CASE("the tables of all steps have current rows", "[handouts][each-step]") {
  const Finished finished = run_atelier({"tables", "--check"});
  INFO(finished.output);
  CHECK(finished.exit_status == 0);
}

TEST_CASE("the targets of a handout's links exist", "[handouts][each-step]") {
  std::vector<std::string> names = {"README"};
  for (const CourseStep& step : judged_steps()) names.push_back(step.name);
  for (const std::string& name : names) {
    INFO(name);
    const std::string handout = read_file(folders().handouts() / (name + ".md"));
    for (const std::string& link : found(handout, R"(\]\(([^)]+)\))")) {
      INFO(link);
      if (link.starts_with("https://")) continue;
      const std::size_t hash = link.find('#');
      const std::string file = hash == 0 ? name + ".md" : link.substr(0, hash);
      REQUIRE(std::filesystem::exists(folders().handouts() / file));
      if (hash != link.npos) CHECK(anchors_of(read_file(folders().handouts() / file)).contains(link.substr(hash + 1)));
    }
  }
}

TEST_CASE("a handout has every case and the points of each tier, and no unknown case", "[handouts][each-step]") {
  for (const CourseStep& step : judged_steps()) {
    INFO(step.name);
    Names cases;
    for (const auto& c : judge::read_case_file(folders().case_file(step.name)).cases)
      if (!c.hidden) cases.insert(c.ask.name);
    CHECK(in_lines(problems_of_cases(folders(), step)) == "");
    CHECK(missing(cases_in_tables(handout_of(step)), cases) == "");
  }
}

TEST_CASE("scenes, settings and outputs in a handout's commands exist", "[handouts][each-step]") {
  for (const CourseStep& step : judged_steps()) {
    INFO(step.name);
    std::string handout = handout_of(step);
    std::replace(handout.begin(), handout.end(), '\n', ' ');  // commands in running text are wrapped
    const json program = listing_of(step);
    CHECK(missing(found(handout, "--scene ([a-z0-9-]+)(?![a-z0-9-]*\\.)"), names_in(program["scenes"])) == "");
    CHECK(missing(found(handout, "--output ([a-z_]+)"), names_in(program["outputs"])) == "");
    Names set = found(handout, "--vary ([a-z0-9._]+)=");
    for (const std::string& list : found(handout, "--set ((?:[a-z0-9._]+=[^ `]+ ?)+)"))
      set.merge(found(list, "([a-z0-9._]+)="));
    CHECK(missing(set, names_in(program["settings"])) == "");
  }
}

TEST_CASE("a step has the title of its step.cmake in its README and its handout", "[handouts][each-step]") {
  for (const CourseStep& step : course()) {
    INFO(step.name);
    const auto first_line = [](const std::string& text) { return text.substr(0, text.find('\n')); };
    CHECK(first_line(read_file(folders().steps() / step.name / "README.md")) == "# " + step.name + ": " + step.title);
    CHECK(first_line(read_file(folders().handouts() / (step.name + ".md"))).find(step.title) != std::string::npos);
  }
}

TEST_CASE("the commands of the editor's tasks exist", "[handouts]") {
  const json file = editor_file("tasks.json");
  for (const json& task : file.at("tasks")) {
    INFO(task.at("label"));
    CHECK(task.at("command") == "./atelier");
    std::vector<std::string> arguments = {task.at("args").at(0)};
    for (const json& argument : task["args"])
      if (argument.get<std::string>().starts_with("--")) arguments.push_back(argument);
    const Finished help = run_atelier({arguments[0], "--help"});
    CHECK(help.exit_status == 0);
    for (const std::string& argument : arguments) CHECK(help.output.find(argument) != std::string::npos);
  }
}
