// The launcher on a bare machine: `doctor` reports what is missing, and installs nothing.
#include <fmt/format.h>

#include <algorithm>

#include "base/file.hpp"
#include "catch.hpp"
#include "command.hpp"
#include "judge/run/build.hpp"

using namespace atelier;
using namespace atelier::test;

namespace {

namespace fs = std::filesystem;

/// A machine on which there is nothing but bash and what every system has.
class BareMachine {
 public:
  BareMachine() {
    fs::create_directory(folder_.path() / "bin");
    for (const char* tool : {"dirname", "readlink", "uname", "sort", "head", "cat"}) {
      const Finished found = run_process({.arguments = {"sh", "-c", std::string("command -v ") + tool}});
      REQUIRE(found.ok());
      fs::create_symlink(found.output.substr(0, found.output.find('\n')), folder_.path() / "bin" / tool);
    }
  }
  fs::path build() const { return folder_.path() / "build"; }
  fs::path bin() const { return folder_.path() / "bin"; }

  /// Runs the launcher of the project in `root`; `changed` are variables that differ from the machine's.
  Finished launch(std::vector<std::string> arguments, const fs::path& root = folders().root,
                  std::map<std::string, std::string> changed = {}) const {
    const Finished bash = run_process({.arguments = {"sh", "-c", "command -v bash"}});
    arguments.insert(arguments.begin(), {bash.output.substr(0, bash.output.find('\n')), (root / "atelier").string()});
    changed.insert({{"PATH", bin().string()}, {"ATELIER_BUILD", build().string()}});
    return run_process({.arguments = arguments, .environment = changed});
  }

  /// A compiler that prints `version`, and fails otherwise if `works` is false.
  void install_compiler(const std::string& version, bool works) const {
    const fs::path program = bin() / "c++";
    write_file(program, "#!/bin/sh\n[ \"$1\" != --version ] || { echo '" + version + "'; exit 0; }\nexit " +
                            (works ? "0\n" : "1\n"));
    fs::permissions(program, fs::perms::owner_all);
  }

 private:
  TemporaryFolder folder_;
};

}  // namespace

TEST_CASE("doctor names what is missing on a bare machine, and installs and builds nothing", "[launcher]") {
  const BareMachine machine;
  const Finished finished = machine.launch({"doctor"});
  INFO(finished.output);
  CHECK(finished.exit_status == 1);
  CHECK(mentions(finished.output, {"✗ compiler", "✗ cmake", "✗ ninja", "✗ build", "not built yet in",
                                   machine.build().string(), "fix: ./atelier list", "Something that is needed"}));
  CHECK_FALSE(fs::exists(machine.build()));
}

TEST_CASE("doctor names a compiler that does not compile the project's C++", "[launcher]") {
  const BareMachine machine;
  machine.install_compiler("c++ (Old) 9.4.0", false);
  CHECK(mentions(machine.launch({"doctor"}).output, {"✗ compiler", "c++ (Old) 9.4.0", "C++20", "GCC 12 or Clang 14"}));
  machine.install_compiler("c++ (New) 12.2.0", true);
  CHECK(mentions(machine.launch({"doctor"}).output, {"✓ compiler   c++ (New) 12.2.0"}));
  // This machine's own, which has compiled this test.
  fs::remove(machine.bin() / "c++");
  fs::create_symlink(judge::read_step_flags(folders().step_flags()).compiler, machine.bin() / "c++");
  CHECK(mentions(machine.launch({"doctor"}).output, {"✓ compiler"}));
}

TEST_CASE("a path in which nothing can be built is refused before anything is installed or made", "[launcher]") {
  const BareMachine machine;
  const TemporaryFolder folder;
  const auto project_in = [&](const std::string& name) {
    const fs::path root = folder.path() / name;
    for (const char* file : {"atelier", "CMakeLists.txt", "common/cli/student/doctor.sh"})
      write_file(root / file, read_file(folders().root / file));
    return root;
  };
  for (const char c : std::string_view(R"(#$":=\[];&'^*?<>|`)")) {
    const std::string character(1, c);
    const fs::path root = project_in("a" + character + "b");
    const Finished finished = machine.launch({"list"}, root);
    INFO(finished.output);
    CHECK(finished.exit_status == 2);
    CHECK(mentions(finished.output, {"a" + character + "b contains the character " + character, "move or rename"}));
  }
  for (const char* name : {"plain", "a b", "\u00fcbung", "a(1)+2,3~!@%{}"}) {
    const Finished finished = machine.launch({"list"}, project_in(name));
    INFO(finished.output);
    CHECK_FALSE(mentions(finished.output, {"contains"}));
  }
  CHECK(mentions(machine.launch({"list"}, project_in("a\nb")).output, {"a?b contains a control character"}));

  struct Row {
    const char *variable, *advice;
  };
  for (const Row& row : {Row{"ATELIER_BUILD", "set ATELIER_BUILD to another folder"},
                         Row{"ATELIER_WORK", "set ATELIER_WORK to another folder"}}) {
    INFO(row.variable);
    const fs::path path = folder.path() / "mine;";
    fs::create_directory(path);
    for (const char* command : {"list", "doctor"}) {
      const Finished finished = machine.launch({command}, folders().root, {{row.variable, path.string()}});
      INFO(finished.output);
      CHECK(mentions(finished.output, {path.string() + " contains the character ;", row.advice}));
    }
    CHECK(fs::is_empty(path));
  }
  CHECK_FALSE(fs::exists(machine.build()));
}

TEST_CASE("doctor's JSON is complete without a build", "[launcher]") {
  const Finished finished = BareMachine().launch({"doctor", "--json"});
  INFO(finished.output);
  CHECK(finished.exit_status == 1);
  const auto printed = nlohmann::json::parse(finished.output);
  CHECK(printed["ok"] == false);
  CHECK(printed["findings"].size() >= 5);
  CHECK(printed["findings"].back()["subject"] == "build");
  CHECK(printed["findings"].back()["mend"] == "./atelier list");
}

TEST_CASE("doctor refuses unknown options, and has --help, on a bare machine too", "[launcher]") {
  const BareMachine machine;
  const Finished refused = machine.launch({"doctor", "--jsno"});
  CHECK(refused.exit_status == 2);
  CHECK(mentions(refused.output, {"error: ", "--jsno", "--json"}));
  const Finished help = machine.launch({"doctor", "--help"});
  CHECK(help.exit_status == 0);
  CHECK(mentions(help.output, {"Exit status"}));
}

TEST_CASE("doctor reports that a program that does not start must be rebuilt", "[launcher]") {
  const BareMachine machine;
  const fs::path program = machine.build() / "bin" / "atelier";
  write_file(program, std::string_view("#!/bin/sh\necho 'libfmt.so.9: cannot open shared object file'\nexit 127\n"));
  fs::permissions(program, fs::perms::owner_all);
  const Finished finished = machine.launch({"doctor"});
  INFO(finished.output);
  CHECK(finished.exit_status == 1);
  CHECK(mentions(finished.output, {"does not start", "libfmt.so.9", "rm -r '" + machine.build().string() + "'"}));
}

TEST_CASE("doctor reports a build folder that was made for another checkout, or was moved", "[launcher]") {
  const BareMachine machine;
  const auto made_for = [&](const fs::path& source, const fs::path& place) {
    write_file(machine.build() / "CMakeCache.txt",
               std::string_view("# a comment\nCMAKE_CACHEFILE_DIR:INTERNAL=" + place.string() +
                                "\nCMAKE_HOME_DIRECTORY:INTERNAL=" + source.string() + "\n"));
    return machine.launch({"doctor"}).output;
  };
  fs::create_directories(machine.build());
  CHECK(
      mentions(made_for("/somewhere/else", machine.build()), {"was made for /somewhere/else", "fix: ./atelier list"}));
  CHECK(mentions(made_for(folders().root, "/somewhere/build"), {"was moved", folders().root.string()}));
  CHECK_FALSE(mentions(made_for(folders().root, machine.build()), {"was moved"}));
}

TEST_CASE("ATELIER_WORK names a folder of one's own, in which steps is made", "[launcher]") {
  const TemporaryFolder folder;
  const auto list = [&](const fs::path& work) {
    return run_process({.arguments = {(folders().build / "bin" / "atelier").string(), "list"},
                        .environment = {{{"ATELIER_WORK", work.string()}}}});
  };
  CHECK(list(folder.path()).ok());
  CHECK(fs::is_directory(folder.path() / "steps"));
  CHECK(mentions(list(folder.path() / "none").output, {"ATELIER_WORK", "there is no such folder"}));
  CHECK_FALSE(fs::exists(folder.path() / "none"));
}

TEST_CASE("without a terminal progress is told at every tenth, at least every 30 seconds, and not at first",
          "[launcher]") {
  struct Row {
    const char *name, *printed;  ///< by the program, as a command of the shell
    int step;                    ///< seconds from one line of it to the next
    std::string told;
  };
  const Row rows[] = {
      {"fast", "seq -f '[%g/50] x' 0 50", 0, ""},
      {"nothing to do", "echo 'ninja: no work to do.'", 3, ""},
      {"slow", "seq -f '[%g/50] x' 0 12", 6, "built 0 of 50 (0 %)\nbuilt 5 of 50 (10 %)\nbuilt 10 of 50 (20 %)\n"},
      {"slower", "seq -f '[%g/1000] x' 1 6", 11, "built 1 of 1000 (0 %)\nbuilt 4 of 1000 (0 %)\n"},
      {"another total", "echo '[1/2] x'; seq -f '[%g/50] x' 0 6", 5, "built 1 of 2 (50 %)\nbuilt 5 of 50 (10 %)\n"},
      {"without numbers", "seq -f 'line %g' 0 5", 11, "waiting, for 11 s\nwaiting, for 44 s\n"},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    const std::string script = fmt::format(
        "source '{}'; time=0; clock() {{ now=$time; time=$((time + {})); }}; "
        "words='' terminal=false doing=waiting; {{ {}; }} | show_progress",
        (folders().root / "atelier").string(), row.step, row.printed);
    const Finished finished = run_process({.arguments = {"bash", "-c", script}});
    CHECK(finished.ok());
    CHECK(finished.output == row.told);
  }
}

TEST_CASE("doctor with a build reports contexts and steps", "[launcher]") {
  const Finished finished = run_atelier({"doctor", "--found", "lack\tninja\tnot found\tget it\n", "--json"});
  INFO(finished.output);
  CHECK(finished.exit_status == 1);  // what the launcher lacks counts
  const auto printed = nlohmann::json::parse(finished.output);
  std::vector<std::string> subjects;
  for (const auto& finding : printed["findings"]) subjects.push_back(finding["subject"]);
  CHECK(subjects.front() == "ninja");
  for (const char* subject : {"display", "osmesa", "egl", "window", "judge", "watching", "sandbox", "steps"}) {
    INFO(subject);
    CHECK(std::find(subjects.begin(), subjects.end(), subject) != subjects.end());
  }
}
