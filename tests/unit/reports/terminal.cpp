#include <fcntl.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <optional>

#include "base/printable.hpp"
#include "catch.hpp"
#include "judge/report/report_terminal.hpp"
#include "sample.hpp"

using namespace atelier;
using namespace atelier::judge;

namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    lines.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return lines;
}

/// An environment variable for the length of a scope; none: unset.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) {
    if (const char* old = std::getenv(name)) old_ = old;
    value ? ::setenv(name, value, 1) : ::unsetenv(name);
  }
  ~Variable() { old_ ? ::setenv(name_, old_->c_str(), 1) : ::unsetenv(name_); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
  std::optional<std::string> old_;
};

}  // namespace

TEST_CASE("the table has one line per case, within the width") {
  for (int width : {40, 60, 100, 200}) {
    const TerminalStyle style{.width = width, .table = true};
    const std::vector<std::string> lines = lines_of(terminal_report(test::sample().steps[1], style));
    INFO(width);
    CHECK(lines[3].starts_with("  + diffuse"));
    CHECK(lines[3].ends_with(" 2/2"));  // a pass has no reason
    CHECK(lines[4].starts_with("  x highlight"));
    CHECK(test::mentions(lines[4], {"0.45/2"}));
    CHECK(test::mentions(lines[6], {"x spot", "0/1", "missing"}));
    if (width >= 60) {
      for (int i = 3; i < 10; ++i) CHECK(lines[std::size_t(i)].size() <= std::size_t(width));
    }
  }
}

TEST_CASE("a failure is explained in order, a pass is not") {
  const std::string text = terminal_report(test::sample(), {});
  std::size_t last = 0;
  for (const char* words : {"x Begin with highlight: all probes", "expected ", "found ", "looks like ", "(no-specular)",
                            "where ", "try next ", "rerun ", "./atelier check 02 --case highlight"}) {
    INFO(words);
    const std::size_t at = text.find(words, last);
    REQUIRE(at != std::string::npos);
    last = at;
  }
  CHECK(text.find("--case diffuse") == std::string::npos);
  CHECK(test::mentions(text, {"<-- wrong", "| about to draw", "4.45 / 11 points, 2 of 8 cases passed"}));
}

TEST_CASE("what the points do not say is said before them") {
  judge::StepResult step = test::sample().steps[1];
  step.caveat = "It uses 01-transforms (untouched). First: ./atelier check 01";
  for (const std::string& text : {judge::terminal_report(step, {}), judge::first_cause_report(step, {})})
    CHECK(text.starts_with(step.caveat + "\n\n02-blinn-phong"));
}

TEST_CASE("equal failures are explained once") {
  const std::string text = terminal_report(test::unbuilt_sample(41), {.table = true});
  CHECK(test::mentions(
      text, {"  x 41 cases   0/82  build failed: blinn_phong.cpp:1:1", "x Begin with these 41 cases: build failed",
             "cases       case-0, case-1,", "case-40", "Fix the first compiler", "note: ../x leads out",
             "0 / 82 points, 0 of 41 cases passed"}));
  const auto times = [&](std::string_view words) {
    int found = 0;
    for (std::size_t at = text.find(words); at != text.npos; at = text.find(words, at + 1)) ++found;
    return found;
  };
  CHECK(times("does not name a type") == 3);  // in the table, of the compiler, in the explanation
  CHECK(times("Fix the first") == 1);
  CHECK(times("--case ") == 1);
  CHECK(times("Something else") == 0);  // what is asked differs from case to case
}

TEST_CASE("without colour there is no escape sequence, with it each ends") {
  CHECK(terminal_report(test::sample(), {}).find('\x1b') == std::string::npos);
  const std::string coloured = terminal_report(test::sample(), {.colour = true});
  std::size_t begun = 0, ended = 0;
  for (std::size_t at = coloured.find("\x1b["); at != std::string::npos; at = coloured.find("\x1b[", at + 1)) {
    (coloured.compare(at, 4, "\x1b[0m") == 0 ? ended : begun) += 1;
  }
  CHECK(begun > 0);
  CHECK(begun == ended);
}

TEST_CASE("links lead to the place of a case in the HTML report") {
  const TerminalStyle style{.report_url = "file:///out/report.html"};
  const SubmissionResult result = test::sample();
  const std::string words = "Begin with highlight: all probes of the functions that it needs pass\x1b]8;;\x1b\\";
  CHECK(test::mentions(terminal_report(result, style),
                       {"\x1b]8;;file:///out/report.html#case-02-blinn-phong.highlight\x1b\\" + words}));
  CHECK(test::mentions(terminal_report(result.steps[1], style),
                       {"\x1b]8;;file:///out/report.html#case-highlight\x1b\\" + words}));
}

TEST_CASE("the path of a report is a link to the case to begin with, where there are links") {
  SubmissionResult result = test::sample();
  const TerminalStyle style{.report_url = "file:///out/report.html"};
  CHECK(report_link("/out", result, {}) == "/out");
  CHECK(report_link("/out", result, style) ==
        "\x1b]8;;file:///out/report.html#case-02-blinn-phong.highlight\x1b\\/out\x1b]8;;\x1b\\");
  for (StepResult& step : result.steps) step.causes.clear();
  CHECK(report_link("/out", result, style) == "\x1b]8;;file:///out/report.html\x1b\\/out\x1b]8;;\x1b\\");
}

TEST_CASE("hostile text is printed with escapes") {
  const std::string text = terminal_report(test::hostile_sample(), {.heat_maps = true});
  CHECK(printable(text, Layout::keep_lines) == text);
  // Nothing that is no line of ours may start a line: output is indented.
  for (const std::string& line : lines_of(text)) CHECK_FALSE(line.starts_with("second line"));
}

TEST_CASE("the style follows the terminal and the environment") {
  const int master = ::posix_openpt(O_RDWR | O_NOCTTY);
  if (master < 0 || ::grantpt(master) != 0 || ::unlockpt(master) != 0) SKIP_TEST("no pseudo-terminal here");
  const int terminal = ::open(::ptsname(master), O_RDWR | O_NOCTTY);
  const int file = ::open("/dev/null", O_WRONLY);
  const Variable plain("NO_COLOR", nullptr), term("TERM", "xterm"), all("LC_ALL", nullptr), type("LC_CTYPE", nullptr);
  const Variable lang("LANG", "C.UTF-8");
  CHECK(terminal_style(terminal).colour);
  CHECK(terminal_style(terminal).unicode);
  CHECK(can_link(terminal));
  CHECK_FALSE(terminal_style(file).colour);
  CHECK_FALSE(can_link(file));
  {
    const Variable no_colour("NO_COLOR", "1");
    CHECK_FALSE(terminal_style(terminal).colour);
    CHECK(can_link(terminal));
  }
  {
    const Variable dumb("TERM", "dumb");
    CHECK_FALSE(terminal_style(terminal).colour);
    CHECK_FALSE(can_link(terminal));
  }
  {
    const Variable first("LC_ALL", "C");
    CHECK_FALSE(terminal_style(terminal).unicode);
  }
  ::close(file), ::close(terminal), ::close(master);
}

TEST_CASE("the heat map keeps places and proportions, and shows a single pixel") {
  Image errors(96, 48);
  errors.at(95, 0) = {1, 1, 1, 1};
  const std::vector<std::string> lines = lines_of(ascii_heat_map(errors));
  REQUIRE(lines.size() == 12 + 2);  // half as many rows as columns would be square: letters are twice as tall as wide
  CHECK(lines[0] == "+" + std::string(48, '-') + "+");
  CHECK(lines[1] == "|" + std::string(47, ' ') + "@|");
  CHECK(lines[2] == "|" + std::string(48, ' ') + "|");

  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 48; ++x) errors.at(x, y) = {1, 1, 1, 1};
  }
  const std::vector<std::string> half = lines_of(ascii_heat_map(errors));
  CHECK(half[2] == "|" + std::string(24, '@') + std::string(24, ' ') + "|");
  CHECK(half[1][48] == ':');  // an eighth of the largest mean: one pixel of the eight in its cell
}

TEST_CASE("the heat map survives the extremes") {
  CHECK(ascii_heat_map(Image()) == "");
  CHECK(ascii_heat_map(Image(1, 1)) == "+-+\n| |\n+-+\n");
  CHECK(lines_of(ascii_heat_map(Image(4096, 1))).size() == 3);
  CHECK(lines_of(ascii_heat_map(Image(1, 4096))).size() == 2048 + 2);
  Image broken(4, 4, {NAN, NAN, NAN, 1});
  broken.at(0, 0).r = INFINITY, broken.at(1, 1).r = -1;
  CHECK(lines_of(ascii_heat_map(broken))[1][1] == '@');
}
