// Bad input gets one clear message and status 2, and leaves nothing behind.
#include <algorithm>

#include "base/file.hpp"
#include "catch.hpp"
#include "command.hpp"

using namespace atelier;
using namespace atelier::test;

TEST_CASE("bad input gets one message, status 2, and leaves nothing behind", "[bad-input]") {
  const TemporaryFolder empty;
  write_file(empty.path() / "not-a.zip", std::string_view("PK nothing"));
  std::filesystem::create_directory(empty.path() / "no-steps");
  const std::string out = (empty.path() / "out").string();
  const auto path = [&](const char* name) { return (empty.path() / name).string(); };
  struct Row {
    const char* name;
    std::vector<std::string> arguments;
    const char* says;
  };
  const Row rows[] = {
      {"no command", {}, "subcommand"},
      {"an unknown command", {"chekc"}, "chekc"},
      {"an unknown option", {"list", "--jsno"}, "--jsno"},
      {"an unknown step", {"check", "99", "--report", out}, "99"},
      {"an ambiguous step", {"check", "-", "--report", out}, "may be"},
      {"an unknown case", {"check", "00", "--case", "no-such-case", "--report", out}, "no-such-case"},
      {"an unknown context", {"check", "00", "--context", "vulkan", "--report", out}, "vulkan"},
      {"no such folder", {"grade", path("nowhere"), "--out", out}, "nowhere"},
      {"a folder without a step", {"grade", path("no-steps"), "--out", out}, "none of the steps"},
      {"no archive", {"grade", path("not-a.zip"), "--out", out}, "not-a.zip"},
      {"no worker", {"grade", "solutions", "--workers", "0", "--out", out}, "--workers"},
      {"a case of no step", {"reference", "--case", "x"}, "--case"},
      {"no step to run", {"run"}, "which step"},
      {"too many repeats", {"bench", "--repeats", "100000"}, "--repeats"},
      {"two tiers", {"test", "--quick", "--all"}, "--all"},
  };
  for (const Row& row : rows) {
    const Finished finished = run_atelier(row.arguments);
    INFO(row.name << ": " << finished.output);
    CHECK(finished.exit_status == 2);
    CHECK(finished.output.starts_with("error: "));
    CHECK(mentions(finished.output, {row.says}));
    CHECK(std::count(finished.output.begin(), finished.output.end(), '\n') == 1);
    CHECK(!std::filesystem::exists(out));
  }
}
