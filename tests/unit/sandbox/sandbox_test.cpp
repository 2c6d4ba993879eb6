// What a confined program reaches, in each tier that works here. ATELIER_SANDBOX_TIER=none runs the tests without a
// sandbox: then they must fail.
#include "sandbox/sandbox.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <random>
#include <set>
#include <sstream>
#include <thread>

#include "base/process.hpp"
#include "catch.hpp"

using namespace atelier;
using namespace atelier::sandbox;
using atelier::test::error_of;
using atelier::test::mentions;
using namespace std::chrono_literals;

namespace fs = std::filesystem;

namespace {

using Words = std::vector<std::string>;

constexpr std::size_t mega = std::size_t(1) << 20;
const fs::path program = fs::path(ATELIER_TEST_PROGRAMS) / "confined_program";

std::vector<Tier> tested_tiers() {
  if (const char* only = std::getenv("ATELIER_SANDBOX_TIER")) return {tier_named(only).value()};
  return {Tier::full, Tier::account};
}

/// Why a tier does not work here; empty: it does.
std::string why_not(Tier tier) {
  static const Possible possible = find_possible_tiers();
  if (tier == Tier::none) return "";
  return tier == Tier::full ? possible.why_not_full : possible.why_not_account;
}

/// Runs the rest of a test once in each tier that works here.
#define IN_EACH_TIER(tier)                                \
  const Tier tier = GENERATE(from_range(tested_tiers())); \
  INFO("tier " << to_string(tier));                       \
  if (!why_not(tier).empty()) SKIP_TEST(to_string(tier) + ": " + why_not(tier))

Room room_for(const Limits& limits = {}) {
  Room room;
  room.readable = {program, program.parent_path().parent_path() / "lib"};
  room.limits = limits;
  return room;
}

/// What it prints goes nowhere.
Launch command(const Words& words) {
  static const Descriptor nowhere(::open("/dev/null", O_WRONLY | O_CLOEXEC));
  Launch wanted;
  wanted.descriptors = {{nowhere.get(), 1}, {nowhere.get(), 2}};
  wanted.arguments = {program.string()};
  wanted.arguments.insert(wanted.arguments.end(), words.begin(), words.end());
  return wanted;
}

/// Runs confined_program to its end.
Finished run_in(const Sandbox& sandbox, const Words& words, const Room& room = room_for(),
                std::chrono::milliseconds limit = 60s) {
  Launch wanted = command(words);
  wanted.descriptors.clear();  // run_process has its own
  Confined confined = sandbox.confine(wanted, room);
  const Finished finished = run_process({.arguments = confined.launch.arguments,
                                         .folder = confined.launch.folder,
                                         .environment = confined.launch.environment,
                                         .time_limit = limit,
                                         .descriptors = confined.launch.descriptors});
  sandbox.program_ended();
  INFO(finished.output);
  CHECK(confined.was_started());
  return finished;
}

std::set<std::string> lines_of(const std::string& text) {
  std::set<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.insert(line);
  return lines;
}

std::string random_word() {
  std::random_device random;
  return fmt::format("atelier-test-{:08x}{:08x}", random(), random());
}

/// Whether a process with this word in its command line runs; a killed one gets two seconds to be gone.
bool runs(const std::string& word) {
  for (int glance = 0; glance < 100; ++glance) {
    bool found = false;
    std::error_code error;
    for (fs::directory_iterator entry("/proc", error), end; !error && entry != end; entry.increment(error)) {
      std::ifstream file(entry->path() / "cmdline");
      std::ostringstream text;
      text << file.rdbuf();
      found |= entry->path().filename() != std::to_string(::getpid()) && text.str().find(word) != std::string::npos;
    }
    if (!found) return false;
    std::this_thread::sleep_for(20ms);
  }
  return true;
}

/// A file that everybody may read, so that only the sandbox protects it.
fs::path public_file(const TemporaryFolder& folder, const std::string& name) {
  write_file(folder.path() / name, "secret");
  fs::permissions(folder.path(), fs::perms(0777));
  fs::permissions(folder.path() / name, fs::perms(0666));
  return folder.path() / name;
}

Descriptor listen_at(const sockaddr* address, socklen_t size) {
  Descriptor end(::socket(address->sa_family, SOCK_STREAM | SOCK_CLOEXEC, 0));
  REQUIRE(::bind(end.get(), address, size) == 0);
  REQUIRE(::listen(end.get(), 4) == 0);
  return end;
}

std::set<std::string> cgroups_of_this_process() {
  std::set<std::string> found;
  const std::string begin = ControlGroup::name_of("");
  std::error_code error;
  for (fs::recursive_directory_iterator entry("/sys/fs/cgroup", error), end; !error && entry != end;
       entry.increment(error))
    if (entry->path().filename().string().starts_with(begin)) found.insert(entry->path().string());
  return found;
}

std::set<std::string> entries(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename().string());
  return names;
}

}  // namespace

TEST_CASE("A confined program opens no file outside of its room") {
  IN_EACH_TIER(tier);
  const TemporaryFolder folder("atelier-test");
  const std::string secret = public_file(folder, "secret").string();
  const char* home = std::getenv("HOME");
  const Words others = {secret,
                        folder.path().string(),
                        std::string(ATELIER_SOURCE_DIR) + "/CMakeLists.txt",
                        home ? home : "/root",
                        "/etc/passwd",
                        "/var"};
  const Sandbox sandbox(tier);
  Words words = others;
  words.insert(words.begin(), "open");
  const Finished opened = run_in(sandbox, words);
  const std::set<std::string> lines = lines_of(opened.output);
  INFO(opened.output);
  REQUIRE(lines.size() == others.size());
  for (const std::string& path : others) {
    INFO(path);
    // What is on the way to its room exists in a file system of its own, without anything else.
    CHECK((lines.contains(path + ": ENOENT") || lines.contains(path + ": EACCES") ||
           (tier == Tier::full && fs::is_directory(path) && lines.contains(path + ": done"))));
  }
  const Finished wrote =
      run_in(sandbox, {"write", secret, secret + "-2", program.string(), "/tmp/../written", "/usr/x"});
  INFO(wrote.output);
  CHECK(wrote.output.find("done") == std::string::npos);
  CHECK(read_file(secret) == "secret");
}

TEST_CASE("A confined program opens what is in its room, and writes where it may") {
  IN_EACH_TIER(tier);
  const TemporaryFolder folder("atelier-test");
  const std::string readable = public_file(folder, "readable").string();
  fs::create_directory(folder.path() / "writable");
  const std::string inside = (folder.path() / "writable/file").string();
  const Sandbox sandbox(tier);
  sandbox.give(folder.path() / "writable");
  Room room = room_for();
  room.readable.push_back(readable);
  room.writable = {folder.path() / "writable"};
  CHECK(run_in(sandbox, {"open", readable}, room).output == readable + ": done\n");
  CHECK(run_in(sandbox, {"write", inside}, room).output == inside + ": done\n");
  CHECK(fs::exists(inside));
  if (tier != Tier::none) CHECK(run_in(sandbox, {"write", readable}, room).output.find("done") == std::string::npos);
}

TEST_CASE("A confined program gets no environment and no descriptor but its own") {
  IN_EACH_TIER(tier);
  ::setenv("ATELIER_TEST_SECRET", "secret", 1);
  const TemporaryFolder folder("atelier-test");
  const Descriptor file(::open(public_file(folder, "secret").c_str(), O_RDONLY)), inherited(::dup2(file.get(), 40));
  const Sandbox sandbox(tier);
  std::set<std::string> names;
  for (const std::string& line : lines_of(run_in(sandbox, {"environment"}).output))
    names.insert(line.substr(0, line.find('=')));
  CHECK((names == std::set<std::string>{"HOME", "TMPDIR"} || names == std::set<std::string>{"HOME", "PWD", "TMPDIR"}));
  CHECK(lines_of(run_in(sandbox, {"descriptors"}).output) == std::set<std::string>{"0", "1", "2"});
}

TEST_CASE("A confined program connects to nothing") {
  IN_EACH_TIER(tier);
  sockaddr_in any{};
  any.sin_family = AF_INET;
  any.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const Descriptor port = listen_at(reinterpret_cast<const sockaddr*>(&any), sizeof any);
  socklen_t size = sizeof any;
  REQUIRE(::getsockname(port.get(), reinterpret_cast<sockaddr*>(&any), &size) == 0);
  const std::string word = random_word();
  sockaddr_un abstract{};
  abstract.sun_family = AF_UNIX;
  std::memcpy(abstract.sun_path + 1, word.data(), word.size());
  const Descriptor name = listen_at(reinterpret_cast<const sockaddr*>(&abstract),
                                    socklen_t(offsetof(sockaddr_un, sun_path) + 1 + word.size()));
  const Finished tried = run_in(Sandbox(tier), {"connect", std::to_string(ntohs(any.sin_port)), word});
  INFO(tried.output);
  CHECK(lines_of(tried.output).size() == 2);
  CHECK(tried.output.find("done") == std::string::npos);
}

TEST_CASE("A confined program reaches no other process") {
  IN_EACH_TIER(tier);
  const Sandbox sandbox(tier);
  const pid_t other = launch({.arguments = {"sleep", "60"}, .folder = {}, .environment = {}, .descriptors = {}});
  const Finished tried =
      run_in(sandbox, {"signal", std::to_string(::getpid()), std::to_string(other), std::to_string(::getppid())});
  kill_and_wait(other);
  INFO(tried.output);
  CHECK(lines_of(tried.output).size() >= 1);
  CHECK(tried.output.find("done") == std::string::npos);
  const std::set<std::string> seen = lines_of(run_in(sandbox, {"processes"}).output);
  INFO(fmt::format("{}", fmt::join(seen, " ")));
  // Of namespaces, the first process and the program; without them, nothing of /proc.
  CHECK(seen.size() <= (tier == Tier::full ? 3 : 0));
}

TEST_CASE("A confined program is somebody else, and gets no privileges") {
  IN_EACH_TIER(tier);
  const Finished told = run_in(Sandbox(tier), {"identity"});
  INFO(told.output);
  CHECK(mentions(told.output, {"new privileges: 0", "root: E"}));
  if (::geteuid() != 0) return;
  const Sandbox first(tier), second(tier);
  CHECK(mentions(told.output, {"user 65", "group 65", "groups 0"}));
  CHECK(run_in(first, {"identity"}).output != run_in(second, {"identity"}).output);
}

TEST_CASE("No two graders take the same account") {
  IN_EACH_TIER(tier);
  if (::geteuid() != 0) SKIP_TEST("only root has accounts to give");
  const auto user_in = [](const Sandbox& sandbox) {
    int user = 0;
    std::sscanf(run_in(sandbox, {"identity"}).output.c_str(), "user %d", &user);
    return user;
  };
  const Sandbox first(tier);
  const int user = user_in(first);
  // As another grader holds its own.
  const std::string name = fmt::format("atelier-account-{}", user + 1);
  sockaddr_un taken{};
  taken.sun_family = AF_UNIX;
  std::memcpy(taken.sun_path + 1, name.data(), name.size());
  const Descriptor other = listen_at(reinterpret_cast<const sockaddr*>(&taken),
                                     socklen_t(offsetof(sockaddr_un, sun_path) + 1 + name.size()));
  const int second = user_in(Sandbox(tier));
  CHECK(second != user);
  CHECK(second != user + 1);
}

TEST_CASE("The kernel refuses a confined program what it does not need") {
  IN_EACH_TIER(tier);
  const Finished tried = run_in(Sandbox(tier), {"kernel"});
  INFO(tried.output);
  for (const char* call : {"ptrace", "unshare", "clone", "mount", "io_uring", "keyctl", "process_vm_readv",
                           "userfaultfd", "inotify_init1", "inotify_add_watch", "bpf", "perf_event_open", "shmget"})
    CHECK(mentions(tried.output, {fmt::format("{}: EPERM\n", call)}));
  CHECK(mentions(tried.output, {"memfd_create: done\n"}));
}

TEST_CASE("Limits hold") {
  IN_EACH_TIER(tier);
  const TemporaryFolder folder("atelier-test");
  const fs::path writable = folder.path() / "writable";
  fs::create_directory(writable);
  const Sandbox sandbox(tier);
  sandbox.give(writable);
  Room room = room_for({.memory = 512 * mega, .file = 3 * mega, .scratch = 5 * mega, .processes = 10});
  room.writable = {writable};
  CHECK(run_in(sandbox, {"memory", std::to_string(600 * mega)}, room).output == "memory: ENOMEM\n");
  CHECK(run_in(sandbox, {"memory", std::to_string(100 * mega)}, room).output == "memory: done\n");
  CHECK(run_in(sandbox, {"fill-file", writable.string(), std::to_string(8 * mega)}, room).output == "3 MiB\n");
  // Without a file system of its own the places where a program writes have no limit but that of each file.
  if (tier == Tier::full) CHECK(run_in(sandbox, {"fill-tmp", std::to_string(8 * mega)}, room).output == "5 MiB\n");
  const Finished forked = run_in(sandbox, {"fork", "40"}, room);
  INFO(forked.output);
  CHECK(std::stoi(forked.output) >= 1);
  CHECK(std::stoi(forked.output) < 12);
}

TEST_CASE("All programs of a sandbox together get no more memory and processes than its control group has") {
  IN_EACH_TIER(tier);
  const Sandbox sandbox(tier, {.memory = 200 * mega, .processes = 20});
  if (tier != Tier::none && !sandbox.has_control_group()) SKIP_TEST("no control group can be made here");
  CHECK(sandbox.memory_kills() == 0);
  const Finished taken = run_in(sandbox, {"memory", std::to_string(400 * mega)}, room_for());
  CHECK((taken.signal == SIGKILL || signal_of_status(taken.exit_status) == SIGKILL));
  CHECK(sandbox.memory_kills() == 1);
  const Finished forked = run_in(sandbox, {"fork", "40"}, room_for());
  INFO(forked.output);
  CHECK(std::stoi(forked.output) >= 1);
  CHECK(std::stoi(forked.output) < 22);
}

TEST_CASE("What a confined program leaves running ends with it") {
  IN_EACH_TIER(tier);
  const std::string word = random_word();
  const Sandbox sandbox(tier);
  SECTION("when it exits") {
    const Finished left = run_in(sandbox, {"leave", word});
    CHECK(left.output == "left\n");
    CHECK(left.ok());
  }
  SECTION("when it is killed") {
    const Finished left = run_in(sandbox, {"leave-and-stay", word}, room_for(), 1500ms);
    CHECK(left.output == "left\n");
    CHECK(left.timed_out);
  }
  CHECK(!runs(word));
  // The next one runs as usual.
  CHECK(run_in(sandbox, {"exit", "0"}).ok());
}

TEST_CASE("A program that has ended takes no other program of its sandbox with it") {
  IN_EACH_TIER(tier);
  const Sandbox sandbox(tier);
  const std::string word = random_word();
  const Confined stays = sandbox.confine(command({"leave-and-stay", word}), room_for());
  const pid_t child = launch(stays.launch);
  CHECK(run_in(sandbox, {"exit", "3"}).exit_status == 3);
  int status = 0;
  std::this_thread::sleep_for(300ms);
  CHECK(::waitpid(child, &status, WNOHANG) == 0);
  kill_and_wait(child);
  sandbox.program_ended();
  CHECK(!runs(word));
}

TEST_CASE("The status of a confined program comes through") {
  IN_EACH_TIER(tier);
  const Sandbox sandbox(tier);
  CHECK(run_in(sandbox, {"exit", "0"}).ok());
  CHECK(run_in(sandbox, {"exit", "7"}).exit_status == 7);
  for (const int number : {SIGSEGV, SIGABRT, SIGKILL}) {
    const Finished ended = run_in(sandbox, {"raise", std::to_string(number)});
    CHECK((ended.signal == number || signal_of_status(ended.exit_status) == number));
  }
}

TEST_CASE("Answers come out of the sandbox, and no more of them than fit") {
  IN_EACH_TIER(tier);
  const TemporaryFolder folder("atelier-test");
  HeldFolder out = folder.held().create_folder("out");
  const Sandbox sandbox(tier);
  sandbox.give(out.path());
  Room room = room_for();
  room.answers = out.path();
  room.answers_bytes = 4 * mega;
  const auto run_and_receive = [&](const Words& words) {
    Confined confined = sandbox.confine(command(words), room);
    const pid_t child = launch(confined.launch);
    std::optional<HeldFolder> received;
    Descriptor folder_inside;
    CHECK(confined.receive_answers(folder_inside));
    if (folder_inside) received = HeldFolder::received(out.path(), std::move(folder_inside));
    siginfo_t info{};
    ::waitid(P_PID, id_t(child), &info, WEXITED | WNOWAIT);
    kill_and_wait(child);
    sandbox.program_ended();
    return received;
  };
  std::optional<HeldFolder> received = run_and_receive({"answer", out.path().string(), "forty-two"});
  CHECK(received.has_value() == (tier == Tier::full));
  const HeldFolder& answers = received ? *received : out;
  const Descriptor file = answers.open_file("answer");
  char text[16] = {};
  CHECK(::read(file.get(), text, sizeof text) == 9);
  CHECK(std::string(text) == "forty-two");
  CHECK(answers.in_place());
  if (tier == Tier::account) return;  // there its size is that of the disk, and of each file
  received = run_and_receive({"fill-files", out.path().string(), std::to_string(8 * mega)});
  std::uintmax_t size = 0;
  for (int i = 0; i < 8; ++i)
    if (const Descriptor block = (received ? *received : out).open_file(std::to_string(i)))
      size += std::uintmax_t(::lseek(block.get(), 0, SEEK_END));
  CHECK(size <= 4 * mega);
  CHECK(size >= 3 * mega);
}

TEST_CASE("Only the sandbox says that it has not started a program") {
  IN_EACH_TIER(tier);
  const Sandbox sandbox(tier);
  Room room = room_for();
  const auto starts = [&](const Launch& wanted) {
    Confined confined = sandbox.confine(wanted, room);
    const Finished finished = run_process({.arguments = confined.launch.arguments,
                                           .folder = confined.launch.folder,
                                           .environment = confined.launch.environment,
                                           .descriptors = confined.launch.descriptors});
    sandbox.program_ended();
    INFO(failure_of_sandbox(finished.output));
    CHECK((confined.was_started() || finished.exit_status != 0));
    return confined.was_started();
  };
  const auto shell = [](const std::string& script) {
    return Launch{.arguments = {"/bin/sh", "-c", script}, .folder = {}, .environment = {}, .descriptors = {}};
  };
  CHECK(starts(shell("echo 'bwrap: a lie'; exit 1")));
  CHECK(starts(shell("echo 'atelier-confine: a lie'; exit 126")));
  // A program may write to each number that it has, or not.
  CHECK(starts(shell("echo x >&4; exit 126")));
  if (tier == Tier::none) return;
  CHECK(!starts({.arguments = {"/usr/bin/no-such-program"}, .folder = {}, .environment = {}, .descriptors = {}}));
  room.writable = {"/no-such-folder"};
  CHECK(starts(shell("exit 0")) == (tier == Tier::account));
  CHECK(sandbox.is_idle());
}

TEST_CASE("Nothing is left of a sandbox") {
  IN_EACH_TIER(tier);
  const std::set<std::string> before = entries(temporary_parent());
  const std::string word = random_word();
  {
    const Sandbox sandbox(tier);
    run_in(sandbox, {"lock"});
    if (tier != Tier::none) CHECK(cgroups_of_this_process().empty() != sandbox.has_control_group());
    // Nobody says that this one has ended.
    const Confined confined = sandbox.confine(command({"leave-and-stay", word}), room_for());
    const pid_t child = launch(confined.launch);
    std::this_thread::sleep_for(300ms);
    kill_and_wait(child);
  }
  CHECK(!runs(word));
  CHECK(cgroups_of_this_process().empty());
  for (const std::string& name : entries(temporary_parent()))
    if (name.starts_with("atelier-scratch")) CHECK(before.contains(name));
  CHECK(!fs::exists(temporary_parent() / "locked"));
}
