#include "base/process.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <thread>

#include "base/descriptor.hpp"
#include "base/file.hpp"
#include "catch.hpp"

using namespace std::chrono_literals;
using atelier::Command;
using atelier::Finished;
using atelier::run_process;
using atelier::TemporaryFolder;
using atelier::test::error_of;
using atelier::test::mentions;

namespace {

Finished shell(const std::string& script, std::chrono::milliseconds limit = 60s) {
  return run_process({.arguments = {"sh", "-c", script}, .time_limit = limit});
}

/// Whether a process of this number still runs; waits a little for a killed one to be gone (a zombie counts as gone).
bool runs(pid_t process) {
  for (int glance = 0; glance < 200; ++glance) {
    std::ifstream file("/proc/" + std::to_string(process) + "/stat");
    std::string number, name, state;
    if (!(file >> number >> name >> state) || state == "Z") return false;
    std::this_thread::sleep_for(10ms);
  }
  return true;
}

}  // namespace

TEST_CASE("The status of a child is reported") {
  struct Row {
    const char *name, *script;
    int exit_status, signal;
    const char* output;
  };
  const Row rows[] = {
      {"success", "echo yes", 0, 0, "yes\n"},
      {"failure", "exit 3", 3, 0, ""},
      {"greatest status", "exit 255", 255, 0, ""},
      {"crash", "kill -SEGV $$", -1, SIGSEGV, ""},
      {"both streams, in order", "echo a; echo b >&2; echo c", 0, 0, "a\nb\nc\n"},
      {"streams closed early", "exec >&- 2>&-; sleep 0.05; exit 4", 4, 0, ""},
      {"standard input is empty", "cat; echo end", 0, 0, "end\n"},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    const Finished finished = shell(row.script);
    CHECK(finished.exit_status == row.exit_status);
    CHECK(finished.signal == row.signal);
    CHECK_FALSE(finished.timed_out);
    CHECK(finished.output == row.output);
    CHECK(finished.ok() == (row.exit_status == 0));
  }
}

TEST_CASE("Arguments reach the program unchanged, without a shell") {
  const Finished finished = run_process({.arguments = {"printf", "%s|", "a b", "$HOME", "*", "", "'\"\n"}});
  CHECK(finished.output == "a b|$HOME|*||'\"\n|");
}

TEST_CASE("The folder and the environment are the requested ones") {
  const TemporaryFolder folder;
  atelier::write_file(folder.path() / "mark", "x");
  CHECK(run_process({.arguments = {"ls"}, .folder = folder.path()}).output == "mark\n");

  ::setenv("ATELIER_UNIT_TEST", "inherited", 1);
  CHECK(shell("echo $ATELIER_UNIT_TEST").output == "inherited\n");
  const Finished own = run_process(
      {.arguments = {"/usr/bin/env"}, .environment = std::map<std::string, std::string>{{"ONLY", "this one"}}});
  CHECK(own.output == "ONLY=this one\n");
  ::unsetenv("ATELIER_UNIT_TEST");
}

TEST_CASE("A program that cannot be started is named") {
  const TemporaryFolder folder;
  atelier::write_file(folder.path() / "plain", "no program");
  const auto message = [](Command command) { return error_of([&] { run_process(command); }); };
  CHECK(mentions(message({.arguments = {"no-such-program"}}), {"no-such-program", "PATH"}));
  CHECK(mentions(message({.arguments = {"/no/such/program"}}), {"/no/such/program", "No such file"}));
  CHECK(mentions(message({.arguments = {folder.path() / "plain"}}), {"plain", "Permission denied"}));
  CHECK(mentions(message({.arguments = {"ls"}, .folder = "/no/such/folder"}), {"ls", "/no/such/folder"}));
  CHECK(mentions(message({}), {"the name of the program to start is missing"}));
}

TEST_CASE("Large output is read to its end and kept up to the limit") {
  const Finished finished =
      run_process({.arguments = {"sh", "-c", "head -c 5000000 /dev/zero; echo end"}, .output_limit = 1000});
  CHECK(finished.ok());  // not blocked on a full pipe
  CHECK(finished.output == std::string(1000, '\0'));
}

TEST_CASE("A child that does not end is killed at the limit, with all its children") {
  struct Row {
    const char *name, *script;
  };
  const Row rows[] = {
      {"sleeps", "echo $$; sleep 1000"},
      {"computes", "echo $$; while :; do :; done"},
      {"floods", "echo $$; exec yes"},
      {"ignores polite signals", "trap '' TERM INT HUP; echo $$; while :; do sleep 1000; done"},
      {"waits for a grandchild", "sleep 1000 & echo $!; wait"},
      {"closes its output", "echo $$; exec >&- 2>&-; sleep 1000"},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    const Finished finished = shell(row.script, 300ms);
    CHECK(finished.timed_out);
    CHECK_FALSE(finished.ok());
    CHECK(finished.exit_status == -1);
    CHECK_FALSE(runs(std::stoi(finished.output)));
  }
}

TEST_CASE("A grandchild that holds the pipe neither delays the answer nor survives") {
  const Finished finished = shell("sleep 1000 & echo $!");
  CHECK(finished.ok());
  CHECK_FALSE(runs(std::stoi(finished.output)));
}

TEST_CASE("A child inherits the three standard streams and nothing else") {
  // A careless descriptor: open, and not close-on-exec.
  const atelier::Descriptor careless(::open("/dev/null", O_RDONLY));
  const atelier::Descriptor high(::fcntl(careless.get(), F_DUPFD, 900));
  const Finished finished = run_process({.arguments = {"ls", "/proc/self/fd"}});
  CHECK(finished.output == "0\n1\n2\n3\n");  // 3: the folder that ls itself reads
}

TEST_CASE("A child starts with default signals, whatever its parent ignores") {
  ::signal(SIGPIPE, SIG_IGN);
  ::signal(SIGCHLD, SIG_IGN);
  const Finished finished = shell("kill -PIPE $$; exit 0");
  ::signal(SIGPIPE, SIG_DFL);
  CHECK(finished.signal == SIGPIPE);
}

TEST_CASE("A parent without standard streams can start children") {
  // Tried in a child of our own, since this program needs its streams.
  const pid_t child = ::fork();
  if (child == 0) {
    for (int stream : {0, 1, 2}) ::close(stream);
    const bool right = shell("cat; echo out; echo err >&2").output == "out\nerr\n";
    ::_exit(right ? 0 : 1);
  }
  int status = -1;
  while (::waitpid(child, &status, 0) < 0) {
  }
  CHECK(status == 0);
}

TEST_CASE("Children of several threads do not affect each other") {
  std::vector<std::string> outputs(8);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < outputs.size(); ++i)
    threads.emplace_back(
        [&outputs, i] { outputs[i] = shell("sleep 0.0" + std::to_string(i) + "; echo " + std::to_string(i)).output; });
  for (std::thread& thread : threads) thread.join();
  for (std::size_t i = 0; i < outputs.size(); ++i) CHECK(outputs[i] == std::to_string(i) + "\n");
}

TEST_CASE("No descriptor is left open, however a child ends") {
  const auto open_now = [] {
    return std::distance(std::filesystem::directory_iterator("/proc/self/fd"), std::filesystem::directory_iterator());
  };
  const auto before = open_now();
  for (int round = 0; round < 20; ++round) shell(round % 2 ? "exit 1" : "kill -9 $$");
  error_of([] { run_process({.arguments = {"/no/such/program"}}); });
  shell("sleep 1000", 20ms);
  CHECK(open_now() == before);
}

TEST_CASE("Signals have understandable names") {
  CHECK(atelier::signal_name(SIGSEGV) == "segmentation fault (SIGSEGV)");
  CHECK(atelier::signal_name(SIGFPE).find("division by zero") != std::string::npos);
  CHECK(atelier::signal_name(61) == "signal 61");
}
