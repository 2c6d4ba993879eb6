#include "base/launch.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>

#include "catch.hpp"

using namespace atelier;
using test::error_of;
using test::mentions;

namespace {

int exit_status(pid_t child) {
  int status = -1;
  while (::waitpid(child, &status, 0) < 0) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// All that comes through a pipe until its other end is closed.
std::string all_from(const Descriptor& pipe) {
  std::string text;
  std::array<char, 256> chunk;
  for (ssize_t got; (got = ::read(pipe.get(), chunk.data(), chunk.size())) > 0;) text.append(chunk.data(), got);
  return text;
}

}  // namespace

TEST_CASE("A child finds each descriptor under the number asked for, and no other") {
  Pipe first = make_pipe(), second = make_pipe();
  // Each stands on the number that the child wants for the other.
  const int a = first.write.get(), b = second.write.get();
  REQUIRE(a < 10);
  REQUIRE(b < 10);
  const std::string script = "echo one >&" + std::to_string(b) + "; echo two >&" + std::to_string(a) +
                             "; for n in 0 3 4 5 6 7 8 9; do { true >&$n; } 2>&- && echo open $n; done >&" +
                             std::to_string(b) + "; exit 0";
  const pid_t child = launch(
      {.arguments = {"sh", "-c", script}, .folder = {}, .environment = std::nullopt, .descriptors = {{a, b}, {b, a}}});
  first.write.reset(), second.write.reset();
  CHECK(exit_status(child) == 0);
  const std::string one = all_from(first.read);
  CHECK(one.starts_with("one\n"));
  CHECK(all_from(second.read) == "two\n");
  for (int number = 3; number < 10; ++number) {
    INFO(number);
    CHECK((one.find("open " + std::to_string(number)) != std::string::npos) == (number == a || number == b));
  }
}

TEST_CASE("Pipes are closed by exec, and keep away from the standard streams") {
  const pid_t child = ::fork();
  if (child == 0) {  // a child of our own, since this program needs its streams
    for (int stream : {0, 1, 2}) ::close(stream);
    const Pipe pipe = make_pipe();
    bool right = true;
    for (int end : {pipe.read.get(), pipe.write.get()})
      right = right && end > 2 && (::fcntl(end, F_GETFD) & FD_CLOEXEC) != 0;
    ::_exit(right ? 0 : 1);
  }
  CHECK(exit_status(child) == 0);
}

TEST_CASE("A child leads its own process group, and its status is reported even if SIGCHLD is ignored") {
  ::signal(SIGCHLD, SIG_IGN);
  const pid_t child =
      launch({.arguments = {"sh", "-c", "sleep 1000"}, .folder = {}, .environment = {}, .descriptors = {}});
  CHECK(::getpgid(child) == child);
  ::kill(-child, SIGTERM);
  int status = 0;
  CHECK(::waitpid(child, &status, 0) == child);
  CHECK((WIFSIGNALED(status) && WTERMSIG(status) == SIGTERM));
  ::signal(SIGCHLD, SIG_DFL);
}

TEST_CASE("A child dies with its parent") {
  Pipe pipe = make_pipe();
  const pid_t parent = ::fork();
  if (parent == 0) {
    launch({.arguments = {"sleep", "1000"}, .folder = {}, .environment = {}, .descriptors = {{pipe.write.get(), 1}}});
    ::_exit(0);
  }
  pipe.write.reset();
  CHECK(exit_status(parent) == 0);
  CHECK(all_from(pipe.read).empty());  // ends, since the child's end is closed
}

TEST_CASE("A descriptor that is not open and a missing program are errors") {
  const auto message = [](Launch wanted) { return error_of([&] { launch(wanted); }); };
  CHECK(mentions(message({.arguments = {"true"}, .folder = {}, .environment = {}, .descriptors = {{-1, 3}}}),
                 {"program 'true' cannot be started", "Bad file descriptor"}));
  CHECK(mentions(message({.arguments = {"/no/such"}, .folder = {}, .environment = {}, .descriptors = {}}),
                 {"/no/such", "No such file"}));
}
