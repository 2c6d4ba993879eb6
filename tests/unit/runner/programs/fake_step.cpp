// A step program that behaves as badly as it is told to: a case's scene says what to do in it, the environment variable
// FAKE_START what to do before the first one. An honest picture holds, in its first pixel's red, the case's number
// within the process, and in green whether the process was given nothing but its own descriptors.
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <string>
#include <thread>

#include "case/case.hpp"
#include "case/exchange.hpp"

extern char** environ;

namespace {

using namespace atelier;
namespace fs = std::filesystem;

std::map<std::string, std::string> options;  ///< "--cases" -> its value
int place = 0;                               ///< of the case within this process, from 1

void tell(const std::string& line) {
  std::cout << std::flush;
  const int progress = std::stoi(options["--progress"]);
  if (::write(progress, line.data(), line.size()) != ssize_t(line.size())) std::exit(7);
}

/// As a program without sanitizers, whose handlers would turn it into an exit.
void segfault() {
  std::signal(SIGSEGV, SIG_DFL);
  std::raise(SIGSEGV);
}

[[noreturn]] void hang() {
  for (;;) std::this_thread::sleep_for(std::chrono::hours(1));
}

bool only_own_descriptors() {
  for (int number = 4; number < 256; ++number)
    if (::fcntl(number, F_GETFD) != -1) return false;
  return true;
}

void draw(const Case& c, const fs::path& file) {
  Image image(c.size.x, c.size.y);
  image.at(0, 0) = {float(place), only_own_descriptors() ? 1.0f : 0.0f, 0, 1};
  write_pixels(file, image);
}

void print_environment() {
  for (char** entry = environ; *entry; ++entry) std::cout << *entry << '\n';
}

void print(const Case& c) {
  std::cout << "out of " << c.name << '\n' << std::flush;
  std::cerr << "err of " << c.name << '\n';
}

void flood() {
  const std::string line(1000, '!');
  for (int i = 0; i < 20'000; ++i) std::cout << line << '\n';  // 20 MB: a pipe that nobody empties holds 64 KiB
}

/// Starts a child that never ends, and holds the lock on FAKE_LOCK while it lives.
void leave_child() {
  const char* path = std::getenv("FAKE_LOCK");
  const int lock = path ? ::open(path, O_RDWR | O_CLOEXEC) : -1;
  if (lock >= 0) ::flock(lock, LOCK_EX);
  if (::fork() == 0) hang();
  if (lock >= 0) ::close(lock);
}

/// Moves a folder into FAKE_AWAY, and puts a link to FAKE_PRECIOUS at its place.
void exchange_folder(const fs::path& folder, const std::string& name) {
  fs::rename(folder, fs::path(std::getenv("FAKE_AWAY")) / name);
  fs::create_directory_symlink(std::getenv("FAKE_PRECIOUS"), folder);
}

/// What a scene's name stands for. A deed that returns is followed by "end".
std::map<std::string, std::function<void(const Case&, const fs::path& pixels)>> deeds() {
  return {
      {"honest", draw},
      {"probe",
       [](const Case& c, const fs::path&) {
         write_values(fs::path(options["--out"]) / (c.name + ".values"), {{double(place)}, {2, 3}});
       }},
      {"nothing", [](const Case&, const fs::path&) {}},
      {"refuses",
       [](const Case& c, const fs::path&) {
         write_case_error(fs::path(options["--out"]) / (c.name + ".error"), "look_at threw: eye and target agree");
       }},
      {"throws",
       [](const Case& c, const fs::path& file) {
         draw(c, file);
         write_case_error(fs::path(options["--out"]) / (c.name + ".exception"), "int was thrown: 42");
       }},
      {"throws to nobody",
       [](const Case&, const fs::path&) {
         std::cerr << "error: int was thrown: 43\n";
         std::abort();
       }},
      {"throws bad_alloc",
       [](const Case& c, const fs::path&) {
         write_case_error(fs::path(options["--out"]) / (c.name + ".exception"), "rotation threw: std::bad_alloc");
       }},
      {"takes memory",
       [](const Case& c, const fs::path& file) {
         const std::string much(std::size_t(500) << 20, 'm');
         if (much.back() == 'm') draw(c, file);
       }},
      {"refuses after drawing",
       [](const Case& c, const fs::path& file) {
         draw(c, file);
         write_case_error(fs::path(options["--out"]) / (c.name + ".error"), "too late");
       }},
      {"segfaults", [](const Case&, const fs::path&) { segfault(); }},
      {"draws, then aborts",
       [](const Case& c, const fs::path& file) {
         draw(c, file);
         std::abort();
       }},
      {"hangs", [](const Case&, const fs::path&) { hang(); }},
      {"leaves its group, hangs",
       [](const Case&, const fs::path&) {
         ::setpgid(0, ::getpgid(::getppid()));
         hang();
       }},
      {"hangs, floods",
       [](const Case&, const fs::path&) {
         for (;;) flood();
       }},
      {"hangs, floods progress",
       [](const Case& c, const fs::path&) {
         for (;;) tell("begin " + c.name + "\nbegin other\nend nobody\n" + std::string(5000, 'x'));
       }},
      {"hangs without pipes",
       [](const Case&, const fs::path&) {
         for (int number = 0; number < 10; ++number) ::close(number);
         hang();
       }},
      {"exits", [](const Case&, const fs::path&) { std::_Exit(0); }},
      {"exits 5", [](const Case&, const fs::path&) { std::_Exit(5); }},
      {"floods",
       [](const Case& c, const fs::path& file) {
         flood();
         draw(c, file);
       }},
      {"prints",
       [](const Case& c, const fs::path& file) {
         print(c);
         draw(c, file);
       }},
      {"prints, segfaults",
       [](const Case& c, const fs::path&) {
         print(c);
         segfault();
       }},
      {"environment",
       [](const Case& c, const fs::path& file) {
         print_environment();
         draw(c, file);
       }},
      {"link",
       [](const Case& c, const fs::path& file) {
         draw(c, file.string() + ".real");
         fs::create_symlink(file.string() + ".real", file);
       }},
      {"fifo", [](const Case&, const fs::path& file) { ::mkfifo(file.c_str(), 0600); }},
      {"folder", [](const Case&, const fs::path& file) { fs::create_directory(file); }},
      {"short",
       [](const Case& c, const fs::path& file) {
         draw(c, file);
         fs::resize_file(file, fs::file_size(file) - 1);
       }},
      {"huge",
       [](const Case& c, const fs::path& file) {
         draw(c, file);
         fs::resize_file(file, std::uintmax_t(1) << 40);  // sparse: costs no disk, only whoever reads it
       }},
      {"exchanges its folder",
       [](const Case& c, const fs::path& file) {
         draw(c, file);
         exchange_folder(options["--out"], c.name);
       }},
      {"exchanges its folder, hangs",
       [](const Case& c, const fs::path&) {
         exchange_folder(fs::path(options["--out"]).parent_path(), c.name);
         hang();
       }},
      {"garbage", [](const Case&, const fs::path& file) { std::ofstream(file) << "no pixels at all\n"; }},
      {"ends on stdout",
       [](const Case& c, const fs::path&) {
         std::cout << "end " << c.name << "\nend honest\n" << std::flush;
         std::_Exit(0);
       }},
      {"ends early",
       [](const Case& c, const fs::path& file) {
         tell("end " + c.name + "\n");
         std::this_thread::sleep_for(std::chrono::milliseconds(50));  // until the lie has been heard
         draw(c, file);
       }},
      {"ends a long line",
       [](const Case& c, const fs::path& file) {
         tell(std::string(200, 'y'));
         std::this_thread::sleep_for(std::chrono::milliseconds(50));  // until its first half has been heard
         tell("end " + c.name + "\n");
         std::this_thread::sleep_for(std::chrono::milliseconds(50));
         draw(c, file);
       }},
      {"ends others",
       [](const Case& c, const fs::path& file) {
         tell("end honest\nend last\nbegin last\nend last\n" + std::string(100'000, 'y') + "\nend last\n");
         draw(c, file);
       }},
      {"leaves a child",
       [](const Case& c, const fs::path& file) {
         leave_child();
         draw(c, file);
       }},
      {"leaves a child, exits",
       [](const Case&, const fs::path&) {
         leave_child();
         std::_Exit(0);
       }},
      {"leaves a child, hangs",
       [](const Case&, const fs::path&) {
         leave_child();
         hang();
       }},
      {"hangs at exit",
       [](const Case& c, const fs::path& file) {
         std::atexit(hang);
         draw(c, file);
       }},
      {"crashes at exit",
       [](const Case& c, const fs::path& file) {
         std::atexit(std::abort);
         draw(c, file);
       }},
      {"stops between cases",
       [](const Case& c, const fs::path& file) {
         draw(c, file);
         tell("end " + c.name + "\n");
         std::_Exit(0);
       }},
  };
}

void start() {
  const char* text = std::getenv("FAKE_START");
  const std::string how = text ? text : "";
  if (how == "refuses") {
    std::cerr << "loading ...\nerror: setting 'shadow.size' is not known; did you mean 'shadow.resolution'?\nbye\n";
    std::exit(2);
  }
  if (how == "lacks a library") {
    std::cerr << "libstep.so: undefined symbol: look_at\n";
    std::exit(127);
  }
  if (how == "exits") {
    std::cout << "all cases passed\n";
    std::exit(0);
  }
  if (how == "segfaults") segfault();
  if (how == "hangs") hang();
}

}  // namespace

int main(int count, char** arguments) {
  for (int i = 1; i + 1 < count; i += 2) options[arguments[i]] = arguments[i + 1];
  start();
  const auto known = deeds();
  for (const Case& c : read_cases(options["--cases"])) {
    ++place;
    tell("begin " + c.name + "\n");
    known.at(c.probe.empty() ? c.scene : "probe")(c, fs::path(options["--out"]) / (c.name + ".pixels"));
    tell("end " + c.name + "\n");
  }
}
