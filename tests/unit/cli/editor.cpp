// .vscode: the problem matchers find the places in the messages that compilers and drivers really print.
#include <set>
#include <sstream>

#include "base/file.hpp"
#include "base/process.hpp"
#include "case/exchange.hpp"
#include "catch.hpp"
#include "editor_tasks.hpp"
#include "gl/contexts.hpp"
#include "gl/shader.hpp"
#include "judge/report/report_terminal.hpp"
#include "judge/run/build.hpp"

using namespace atelier;
using namespace atelier::test;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

const char* const step = "90-sums";

/// The distinct problems in a text, by all matchers of a task.
std::set<json> problems_in(const std::string& text, const std::string& task) {
  std::set<json> problems;
  const json matchers = editor_task(task).at("problemMatcher");
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    for (const json& matcher : matchers)
      if (const auto problem = problem_in(line, matcher)) problems.insert(*problem);
  return problems;
}

std::set<std::string> compilers() {
  std::set<std::string> there;
  for (const char* name : {"g++", "clang++"})
    if (run_process({.arguments = {"sh", "-c", std::string("command -v ") + name}}).ok()) there.insert(name);
  return there;
}

/// What the judge keeps of a compiler's messages about a student's file.
std::string build_log(const std::string& compiler, const std::string& source) {
  const TemporaryFolder folder;
  const judge::StepFlags flags{.compiler = compiler,
                               .compiler_version = "",
                               .compile = {"-std=c++20", "-fPIC", "-Wall"},
                               .link = {"-shared"},
                               .files = {{step, {"sums.cpp"}}},
                               .headers = {},
                               .uses = {},
                               .titles = {}};
  write_file(folder.path() / step / "sums.cpp", source);
  return judge::build_step(flags, step, folder.path() / step, folder.path() / "out").log;
}

/// The report of a step of which no case could be built.
judge::StepResult unbuilt(const std::string& reason, const std::string& log) {
  judge::CaseResult result;
  result.name = "sum", result.status = judge::Status::build_failed, result.reason = reason;
  judge::StepResult unbuilt;
  unbuilt.step = step, unbuilt.build_log = log;
  unbuilt.cases = {result};
  unbuilt.causes = {{.kind = judge::Cause::Kind::no_answer, .functions = {}, .shown = {0}, .waiting = {}}};
  return unbuilt;
}

/// Every text that has these messages: check's and watch's in both sets of signs, narrow ones too; and run's.
std::vector<std::string> texts_with(const judge::StepResult& result, const std::string& of_run) {
  std::vector<std::string> texts = {of_run};
  for (const bool unicode : {false, true}) {
    const judge::TerminalStyle style{.unicode = unicode, .width = 40};
    texts.push_back(judge::terminal_report(result, style));
    texts.push_back(judge::first_cause_report(result, style));
  }
  return texts;
}

}  // namespace

TEST_CASE("editors find the place of a compiler's message") {
  struct Row {
    const char *source, *line, *column, *severity, *message;
  };
  const Row rows[] = {
      {"int sum(int a, int b) {\n  return a + wrong + b;\n}\n", "2", "14", "error", "wrong"},
      {"int sum(int a, int b) {\n  int unused;\n  return a + b;\n}\n", "2", "7", "warning", "unused"},
      {"#include <vector>\n#include \"none.hpp\"\n", "2", "", "", "#include \"none.hpp\""},  // the project's own words
  };
  REQUIRE(!compilers().empty());
  for (const std::string& compiler : compilers())
    for (const Row& row : rows) {
      const std::string log = build_log(compiler, row.source);
      const std::string first = log.substr(0, log.find('\n'));
      for (const std::string& text : texts_with(unbuilt(first, log), "error: 90-sums does not build:\n" + log)) {
        INFO(compiler << "\n" << text);
        const std::set<json> problems = problems_in(text, "check");
        REQUIRE(problems.size() == 1);
        const json problem = *problems.begin();
        CHECK(problem["file"] == "sums.cpp");
        CHECK(problem["line"] == row.line);
        CHECK(problem["column"] == row.column);
        CHECK(problem["severity"] == row.severity);
        CHECK(mentions(problem["message"].get<std::string>(), {row.message}));
        CHECK(log.find(problem["message"].get<std::string>() + "\n") != log.npos);  // all of it
      }
    }
}

TEST_CASE("editors find the place of a driver's message, and of the project's own about a shader") {
  struct Row {
    const char *source, *line, *severity, *message;
  };
  const Row rows[] = {
      {"float sum(float a, float b) {\n  return a + wrong + b;\n}\n", "2", "error", "wrong"},
      {"\n#version 450\n", "2", "", "remove this #version"},
  };
  const TemporaryFolder folder;
  const auto find = [&](const std::string& name) { return folder.path() / name; };
  for (const Row& row : rows) {
    write_file(folder.path() / step / "sums.glsl", row.source);
    on_every_context([&](Gl& gl) {
      const std::string said = error_of([&] {
        const ShaderSource vertex =
            assemble_shader_text(find, "void main() { gl_Position = vec4(0); }\n", "vertex", {});
        build_program(gl, vertex, assemble_shader(find, std::string(step) + "/sums.glsl", {}));
      });
      write_case_error(folder.path() / "error", said);
      const std::string reason = read_case_error(folder.held(), "error");
      for (const std::string& text : texts_with(unbuilt(reason, ""), "error: " + said + "\n")) {
        INFO(text);
        const std::set<json> problems = problems_in(text, "check");
        REQUIRE(!problems.empty());  // one line of a report, all lines of run
        bool said_so = false;
        for (const json& problem : problems) {
          CHECK(problem["file"] == "90-sums/sums.glsl");
          CHECK(problem["line"] == row.line);
          CHECK(problem["severity"] == row.severity);
          const std::string message = problem["message"];
          CHECK((said + "\n").find(message + "\n") != said.npos);  // all of it
          said_so = said_so || mentions(message, {row.message});
        }
        CHECK(said_so);
      }
    });
  }
}

TEST_CASE("nothing else in a report looks like a problem to an editor") {
  for (const char* line : {
           "90-sums  Sums  0 / 2 points, 0 of 1 cases passed",
           "  rerun       ./atelier check 90-sums --case sum",
           "  \u2502 sums.cpp: In function 'int sum(int, int)':",
           "  \u2502 sums.cpp:7:12:   required from here",
           "  \u2502 sums.cpp:9:3: note: declared here",
           "  \u2502 In file included from sums.cpp:1:",
           "  \u2502     2 |   return a::b:3;",
           "  may be in   sums.glsl",
       }) {
    INFO(line);
    CHECK(problems_in(line, "check").empty());
  }
}

TEST_CASE("the tasks of the editor agree with each other and with the launch configurations") {
  const json check = editor_task("check").at("problemMatcher");
  CHECK(editor_task("run").at("problemMatcher") == check);
  json watch = editor_task("watch").at("problemMatcher");
  REQUIRE(watch.at(0).contains("background"));
  watch[0].erase("background");
  CHECK(watch == check);
  CHECK(editor_task("watch").at("isBackground") == true);
  const json launch = editor_file("launch.json");
  for (const json& configuration : launch.at("configurations")) {
    INFO(configuration.dump());
    CHECK_NOTHROW(editor_task(configuration.at("preLaunchTask")));
    CHECK(configuration.at("args") == editor_task("run").at("args"));
  }
}
