// The launcher on a bare machine: `doctor` reports what is missing, and installs nothing.
#include <algorithm>

#include "base/file.hpp"
#include "catch.hpp"
#include "command.hpp"

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

  Finished launch(std::vector<std::string> arguments) const {
    const Finished bash = run_process({.arguments = {"sh", "-c", "command -v bash"}});
    arguments.insert(arguments.begin(),
                     {bash.output.substr(0, bash.output.find('\n')), (folders().root / "atelier").string()});
    return run_process(
        {.arguments = arguments, .environment = {{{"PATH", bin().string()}, {"ATELIER_BUILD", build().string()}}}});
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
