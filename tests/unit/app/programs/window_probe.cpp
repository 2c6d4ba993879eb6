// A step program around FakeStep, for the window's tests: reads the usual command line and opens the window.
//
// FAKE_STARTS=FILE   adds a line with the arguments to it at every start; from the second start on the window quits
// after
//                    three frames
// FAKE_TOUCH=FILE    writes it anew at the first start's first drawing, as a compiler does with a step's library
#include <fmt/core.h>

#include <cstdlib>
#include <fstream>

#include "../fake_step.hpp"
#include "app/command_line.hpp"
#include "app/list.hpp"
#include "app/window/module.hpp"
#include "base/module.hpp"

namespace {

using namespace atelier;

/// Which start this is, from 1.
int note_start(const char* file, int count, char** arguments) {
  std::ofstream out(file, std::ios::app);
  for (int i = 1; i < count; ++i) out << arguments[i] << ' ';
  out << '\n';
  out.close();
  const std::string lines = read_file(file);
  return int(std::count(lines.begin(), lines.end(), '\n'));
}

std::unique_ptr<StepProgram> make(bool touching) {
  auto program = std::make_unique<test::FakeStep>();
  if (const char* file = std::getenv("FAKE_TOUCH"); file && touching)
    program->on_draw = [file, raw = program.get()] {
      if (raw->draws == 1) write_file(file, std::string_view("a newer library"));
    };
  return program;
}

int run(int count, char** arguments) {
  const auto line = parse_command_line(count, arguments, test::step_name);
  if (!line) return exit_ok;
  if (line->list) {
    fmt::print("{}", list_as_text(test::FakeStep().description()));
    return exit_ok;
  }
  const char* starts = std::getenv("FAKE_STARTS");
  const int start = starts ? note_start(starts, count, arguments) : 1;
  if (start > 1) setenv("ATELIER_WINDOW_FRAMES", "3", 1);
  const StepIdentity identity{test::step_name, {test::step_name}};
  using Show = int (*)(const WindowRequest&);
  const auto show = reinterpret_cast<Show>(module_symbol("atelier-window", "atelier_show_window"));
  return show({identity, line->implementations.value(), *line, [&] { return make(start == 1); }});
}

}  // namespace

int main(int count, char** arguments) {
  try {
    return run(count, arguments);
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return exit_usage;
  }
}
