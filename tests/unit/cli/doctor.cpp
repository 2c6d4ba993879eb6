#include "cli/student/doctor.hpp"

#include <algorithm>
#include <csignal>
#include <nlohmann/json.hpp>

#include "catch.hpp"

using namespace atelier;
using atelier::test::error_of;
using atelier::test::mentions;
using State = Finding::State;

namespace {

ContextTrial working(const char* kind, const char* renderer = "llvmpipe (LLVM 15.0.6, 256 bits)") {
  return {.version = "4.5 (Core Profile) Mesa 22.3.6", .renderer = renderer, .kind = kind};
}

ContextTrial failing(const char* why) {
  return {.failure = why};
}

ContextTrials usual() {
  return {.osmesa = working("osmesa"),
          .egl = working("egl"),
          .window = failing("no display"),
          .headless = working("osmesa")};
}

const char* const apt = "sudo apt-get install --no-install-recommends";

const Finding& about(const std::vector<Finding>& findings, const std::string& subject) {
  const auto found =
      std::find_if(findings.begin(), findings.end(), [&](const Finding& f) { return f.subject == subject; });
  REQUIRE(found != findings.end());
  return *found;
}

}  // namespace

TEST_CASE("The launcher's findings are read") {
  const auto findings = parse_findings(
      "good\tcmake\t3.25.1\t\n"
      "note\tpackages\tuseful: git\tapt-get install git\n"
      "lack\tninja\tnot found");
  REQUIRE(findings.size() == 3);
  CHECK(findings[0].state == State::good);
  CHECK(findings[0].fix.empty());
  CHECK(findings[1].subject == "packages");
  CHECK(findings[1].words == "useful: git");
  CHECK(findings[1].fix == "apt-get install git");
  CHECK(findings[2].state == State::lack);
  CHECK(parse_findings("").empty());
  for (const char* wrong : {"bad\tcmake\t3.25.1\t", "good", "good\tcmake", "\n"}) {
    INFO(wrong);
    CHECK(mentions(error_of([&] { parse_findings(wrong); }), {"good, note or lack"}));
  }
}

TEST_CASE("One missing requirement decides the status, notes do not") {
  const Finding good{State::good, "a", "", ""}, note{State::note, "b", "", ""}, lack{State::lack, "c", "", ""};
  CHECK(status_of({}) == exit_ok);
  CHECK(status_of({good, note}) == exit_ok);
  CHECK(status_of({good, lack, note}) == exit_failed);
}

TEST_CASE("Findings are printed with the command that fixes them") {
  const std::vector<Finding> findings = {{State::good, "cmake", "3.25.1", ""},
                                         {State::lack, "ninja", "not \"found\"", "apt-get install ninja-build"}};
  CHECK(to_text(findings) ==
        "✓ cmake      3.25.1\n"
        "✗ ninja      not \"found\"\n"
        "             fix: apt-get install ninja-build\n"
        "\nSomething that is needed is missing: see the lines with ✗.\n");
  CHECK(mentions(to_text({findings[0]}), {"Everything needed is installed."}));

  const auto json = nlohmann::json::parse(to_json(findings));
  CHECK(json["ok"] == false);
  CHECK(json["findings"][1]["state"] == "lack");
  CHECK(json["findings"][1]["words"] == "not \"found\"");
  CHECK(json["findings"][1]["mend"] == "apt-get install ninja-build");
}

TEST_CASE("A trial's message is found among a driver's messages") {
  ContextTrial window = working("window");
  window.scale = 1.5f;
  const ContextTrial read = read_trial({.output = "libEGL warning: chatter\n" + trial_text(window) + "more chatter"});
  CHECK(read.works());
  CHECK(read.version == window.version);
  CHECK(read.renderer == window.renderer);
  CHECK(read.kind == "window");
  CHECK(read.scale == window.scale);
  CHECK_FALSE(read_trial({.output = trial_text(working("egl"))}).scale);
}

TEST_CASE("A failed trial reports how it ended") {
  const std::string said = trial_text(working("egl"));  // believed only of a program that ends well
  struct Row {
    const char* name;
    Finished finished;
    const char* says;
  };
  const Row rows[] = {
      {"hung", {.exit_status = -1, .signal = SIGKILL, .timed_out = true, .output = said, .seconds = 5}, "within 5 s"},
      {"crashed", {.exit_status = -1, .signal = SIGSEGV, .output = said}, "SIGSEGV"},
      {"refused", {.exit_status = 2, .output = "chatter\nerror: OSMesa is not installed\n"}, "OSMesa is not installed"},
      {"ended", {.exit_status = 127, .output = "cannot open shared object file"}, "status 127"},
      {"silent", {.output = "chatter"}, "printed nothing"},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    const ContextTrial trial = read_trial(row.finished);
    CHECK_FALSE(trial.works());
    CHECK(mentions(trial.failure, {row.says}));
  }
}

TEST_CASE("One kind of context is enough, none is a problem") {
  struct Row {
    const char* name;
    ContextTrials trials;
    State judge;
    std::initializer_list<std::string_view> says;
  };
  const ContextTrial none = failing("not installed");
  const ContextTrial gpu = working("egl", "Mesa Intel(R) UHD Graphics 620");
  const Row rows[] = {
      {"all but a window", usual(), State::good, {"osmesa", "llvmpipe", "like the references"}},
      {"EGL alone", {none, working("egl"), none, working("egl")}, State::good, {"egl"}},
      {"a GPU alone", {none, gpu, none, gpu}, State::note, {"Intel", "edges", "grader"}},
      {"nothing", {none, none, none, none}, State::lack, {"OpenGL 3.3"}},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    const auto findings = context_findings(row.trials, apt);
    CHECK(about(findings, "judge").state == row.judge);
    CHECK(mentions(about(findings, "judge").words, row.says));
    CHECK((status_of(findings) == exit_ok) == (row.judge != State::lack));
  }
}

TEST_CASE("The fix for a missing driver names this system's packages") {
  const ContextTrials nothing{failing("a"), failing("b"), failing("c"), failing("d")};
  struct Row {
    const char *install, *fix;
  };
  const Row rows[] = {
      {apt, "sudo apt-get install --no-install-recommends libegl1 libegl-mesa0 libgl1-mesa-dri"},
      {"dnf install", "dnf install mesa-libEGL mesa-dri-drivers"},
      {"pacman -S --needed", "pacman -S --needed mesa"},
      {"", ""},
  };
  for (const Row& row : rows) CHECK(about(context_findings(nothing, row.install), "judge").fix == row.fix);
}

TEST_CASE("A window's scale is reported if there is a window") {
  ContextTrials trials = usual();
  const auto without = context_findings(trials, apt);
  CHECK(std::none_of(without.begin(), without.end(), [](const Finding& f) { return f.subject == "scale"; }));
  trials.window = working("window");
  trials.window.scale = 2.0f;
  CHECK(mentions(about(context_findings(trials, apt), "scale").words, {"2 "}));
}

TEST_CASE("Displays are named, and a missing display is not a problem") {
  CHECK(display_finding("", "").state == State::note);
  CHECK(display_finding(":0", "").words == "X11 :0");
  CHECK(display_finding(":0", "wayland-0").words == "X11 :0, Wayland wayland-0");
  CHECK(display_finding(":0\033[2J", "").words.find('\033') == std::string::npos);
}

TEST_CASE("If the system does not report saved files, doctor says what happens instead") {
  CHECK(watching_finding(true).state == State::good);
  CHECK(watching_finding(false).state == State::note);
  CHECK(mentions(watching_finding(false).words, {"200 ms"}));
}

TEST_CASE("If the sandbox cannot start, the reason is reported") {
  struct Row {
    const char* name;
    SandboxTrial trial;
    State state;
    std::initializer_list<std::string_view> says;
    const char* fix;
  };
  using sandbox::Tier;
  const std::string missing = "bwrap is not there", root = "only root can";
  const Row rows[] = {
      {"works", {.possible = {.best = Tier::full}, .installed = true}, State::good, {"full", "namespaces"}, ""},
      {"in a container",
       {.possible = {.best = Tier::account, .why_not_full = "Operation not permitted"}, .installed = true},
       State::note,
       {"account", "Operation not permitted"},
       ""},
      {"missing",
       {.possible = {.best = Tier::none, .why_not_full = missing, .why_not_account = root}},
       State::note,
       {"none", "not graded", missing, root},
       "sudo apt-get install --no-install-recommends bubblewrap"},
      {"forbidden",
       {.possible = {.best = Tier::none,
                     .why_not_full = "setting up uid map: Permission denied",
                     .why_not_account = root},
        .installed = true,
        .setting = "user.max_user_namespaces=10000"},
       State::note,
       {"Permission denied"},
       "sudo sysctl user.max_user_namespaces=10000"},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    const Finding finding = sandbox_finding(row.trial, apt);
    CHECK(finding.state == row.state);
    CHECK(mentions(finding.words, row.says));
    CHECK(finding.fix == row.fix);
  }
  CHECK(sandbox_finding({}, "").fix.empty());  // an unknown system has no command
}

TEST_CASE("Steps that run share one line, each other step has its own") {
  const std::vector<StepTrial> trials = {
      {.name = "00-hello", .built = true},
      {.name = "01-transforms", .built = true},
      {.name = "02-blinn-phong"},
      {.name = "03-shadow-mapping", .built = true, .failure = "libatelier.so: no such file"},
      {.name = "04-point-shadows", .built = true, .failure = "04: its code is not built yet: run ./atelier check 04"},
  };
  const auto findings = step_findings(trials, usual(), "/b");
  REQUIRE(findings.size() == 4);
  CHECK(findings[0].state == State::good);
  CHECK(mentions(findings[0].words, {"00-hello, 01-transforms can be checked", "not run in a window"}));
  CHECK(findings[1].state == State::lack);
  CHECK(mentions(findings[1].words, {"02-blinn-phong is not built"}));
  CHECK(findings[1].fix == "./atelier list");
  CHECK(mentions(findings[2].words, {"03-shadow-mapping does not start", "no such file"}));
  CHECK(findings[2].fix == "rm -r '/b' && ./atelier list");
  CHECK(findings[3].state == State::note);  // nobody shall lose a build for this
  CHECK(findings[3].fix == "./atelier check 04");

  ContextTrials nothing;
  nothing.headless = failing("none");
  CHECK(step_findings({trials[0]}, nothing, "/b").empty());  // the judge's line says why
}
