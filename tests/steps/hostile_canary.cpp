#include "hostile_canary.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <mqueue.h>
#include <netinet/in.h>
#include <signal.h>
#include <sys/ipc.h>
#include <sys/msg.h>
#include <sys/sem.h>
#include <sys/shm.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <random>
#include <sstream>
#include <thread>

#include "base/error.hpp"
#include "base/launch.hpp"
#include "base/printable.hpp"
#include "base/system_reason.hpp"
#include "command.hpp"

namespace atelier::test {

namespace fs = std::filesystem;

namespace {

// As in tests/hostile/tools.cpp.
const fs::path canary_folder = "/tmp/atelier-canary";
constexpr std::uint16_t canary_port = 47811;
const std::string canary_process = "atelier-canary-process", left_process = "hostile-left";
constexpr key_t shared_key = 0x47811;

/// Two numbers: one would be too likely to be in some other file.
std::string random_word() {
  std::random_device random;
  return fmt::format("canary-{:08x}{:08x}", random(), random());
}

Descriptor listener(const void* address, socklen_t size, int family, const std::string& what) {
  Descriptor end(::socket(family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  const int yes = 1;
  ::setsockopt(end.get(), SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  if (::bind(end.get(), static_cast<const sockaddr*>(address), size) != 0 || ::listen(end.get(), 8) != 0)
    throw Error(fmt::format("{}: cannot be listened at: {}", what, system_reason()));
  return end;
}

Descriptor listen_at_port() {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(canary_port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return listener(&address, sizeof address, AF_INET, fmt::format("port {}", canary_port));
}

/// `name` begins with NUL for the abstract namespace.
Descriptor listen_at_name(const std::string& name) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::memcpy(address.sun_path, name.data(), name.size());
  const auto size = socklen_t(offsetof(sockaddr_un, sun_path) + name.size());
  return listener(&address, size, AF_UNIX, "the socket of the canary");
}

/// Whether somebody has connected, or waits to be let in.
bool was_reached(const Descriptor& listening) {
  return Descriptor(::accept4(listening.get(), nullptr, nullptr, SOCK_CLOEXEC)).get() >= 0;
}

std::string first_line_of(const fs::path& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  return line;
}

std::string whole_file(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// Files that the victims' folder has: names of answers, which a judge that is led there would read and remove.
const std::vector<std::string> victims = {"translation.values", "robot.pixels", "job.json", "out/translation.values"};

/// What a hostile program leaves where it can write.
std::vector<fs::path> places_of_marks() {
  std::vector<fs::path> places;
  const char* home = std::getenv("HOME");
  for (const fs::path& folder :
       {fs::path("/tmp"), fs::path("/var/tmp"), fs::path("/dev/shm"), fs::path("/run"), fs::path("/run/lock"),
        fs::path("/usr/local"), fs::path("/"), fs::path(home ? home : "/root"), folders().root, folders().build,
        fs::path(home ? home : "/root") / ".cache/mesa_shader_cache"})
    places.push_back(folder / "atelier-hostile-written");
  places.push_back("/dev/shm/atelier-hostile-shared");
  places.push_back("/tmp/atelier-hostile.so");
  return places;
}

/// Changed and new files of the project, as git sees them; empty without git.
std::string project_state() {
  try {
    return run_process({.arguments = {"git", "-C", folders().root.string(), "status", "--porcelain", "-uall"}}).output;
  } catch (const Error&) {
    return "";
  }
}

}  // namespace

std::vector<std::pair<fs::path, std::string>> files_with_bytes(const fs::path& folder) {
  std::vector<std::pair<fs::path, std::string>> files;
  if (!fs::exists(folder)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied))
    if (entry.is_regular_file() && !entry.is_symlink()) files.emplace_back(entry.path(), whole_file(entry.path()));
  return files;
}

Canary::Canary() : secret_(random_word()), honest_(random_word()), project_before_(project_state()) {
  for (const fs::path& place : places_of_marks())
    if (fs::exists(fs::symlink_status(place)))
      throw Error(fmt::format("{}: left by an earlier run; remove it", place.string()));
  fs::remove_all(canary_folder);
  fs::create_directories(canary_folder / "victims/out");
  // Everybody may read and write here, so that only the sandbox protects it, and not another user's rights.
  for (const char* folder : {"", "victims", "victims/out"})
    fs::permissions(canary_folder / folder, fs::perms::all, fs::perm_options::replace);
  const auto publish = [](const fs::path& file, const std::string& text) {
    write_file(file, text);
    fs::permissions(file, fs::perms(0666), fs::perm_options::replace);
  };
  publish(canary_folder / "secret.txt", secret_ + "\n");
  for (const std::string& name : victims) publish(canary_folder / "victims" / name, secret_ + "\n");
  // Its programs may have another user's number.
  fs::permissions(temporary_.path(), fs::perms(0755), fs::perm_options::replace);
  port_ = listen_at_port();
  abstract_ = listen_at_name(std::string(1, '\0') + "atelier-canary");
  file_ = listen_at_name((canary_folder / "socket").string());
  fs::permissions(canary_folder / "socket", fs::perms::all, fs::perm_options::replace);
  process_ = launch({.arguments = {"bash", "-c", "exec -a \"$0\" sleep 3600", canary_process},
                     .folder = {},
                     .environment = {},
                     .descriptors = {}});
}

Canary::~Canary() {
  for (const pid_t process : left_processes()) ::kill(process, SIGKILL);
  if (process_ > 0) kill_and_wait(process_);
  std::error_code ignored;
  fs::remove_all(canary_folder, ignored);
  for (const fs::path& place : places_of_marks()) fs::remove(place, ignored);
  if (const int id = ::shmget(shared_key, 0, 0); id >= 0) ::shmctl(id, IPC_RMID, nullptr);
  if (const int id = ::semget(shared_key, 0, 0); id >= 0) ::semctl(id, 0, IPC_RMID);
  if (const int id = ::msgget(shared_key, 0); id >= 0) ::msgctl(id, IPC_RMID, nullptr);
  ::mq_unlink("/atelier-hostile");
}

Finished Canary::grade(const std::vector<std::string>& arguments) const {
  std::map<std::string, std::string> environment = own_environment();
  environment["ATELIER_CANARY"] = "ATELIER_CANARY " + secret_;
  environment["TMPDIR"] = temporary_.path().string();
  // A shell, since run_process closes all other descriptors.
  std::vector<std::string> all = {"bash",
                                  "-c",
                                  "exec 9<\"$0\" 8</tmp; exec \"$@\"",
                                  (canary_folder / "secret.txt").string(),
                                  (folders().build / "bin" / "atelier").string(),
                                  "grade"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  if (const char* tier = std::getenv("ATELIER_HOSTILE_SANDBOX"); tier) all.insert(all.end(), {"--sandbox", tier});
  return run_process({.arguments = all,
                      .folder = folders().root,
                      .environment = environment,
                      .time_limit = std::chrono::seconds(3300),
                      .output_limit = 16 << 20});
}

std::set<pid_t> Canary::left_processes() const {
  std::set<pid_t> left;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator("/proc", error)) {
    const std::string name = entry.path().filename().string();
    if (name.find_first_not_of("0123456789") != name.npos || std::stol(name) == ::getpid()) continue;
    const bool is_named = first_line_of(entry.path() / "comm") == left_process;
    if (is_named || whole_file(entry.path() / "cmdline").find(temporary_.path().string()) != std::string::npos)
      left.insert(pid_t(std::stol(name)));
  }
  return left;
}

std::vector<std::string> Canary::found_changed() {
  std::vector<std::string> changed;
  const auto require = [&](bool holds, const std::string& sentence) {
    if (!holds) changed.push_back(sentence);
  };
  // The kernel may need a moment to end all processes of a sandbox.
  for (int tries = 0; tries < 50 && !left_processes().empty(); ++tries)
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  for (const pid_t process : left_processes())
    require(false,
            fmt::format("process {} is left: {} {}", process, first_line_of(fmt::format("/proc/{}/comm", process)),
                        printable(first_line_of(fmt::format("/proc/{}/cmdline", process)))));

  int status = 0;
  if (process_ > 0 && ::waitpid(process_, &status, WNOHANG) != 0) process_ = -1;
  require(process_ > 0, "the test's process was ended");
  require(!was_reached(port_), "somebody has connected to the port");
  require(!was_reached(abstract_), "somebody has connected to the abstract socket");
  require(!was_reached(file_), "somebody has connected to the socket's file");

  std::set<std::string> expected = {"secret.txt", "socket", "victims", "victims/out"};
  for (const std::string& name : victims) {
    expected.insert("victims/" + name);
    require(whole_file(canary_folder / "victims" / name) == secret_ + "\n",
            "victims/" + name + " was changed or removed");
  }
  for (const auto& entry : fs::recursive_directory_iterator(canary_folder))
    if (const std::string name = entry.path().lexically_relative(canary_folder).string(); !expected.contains(name))
      require(false, printable(entry.path().string()) + " was written");
  require(whole_file(canary_folder / "secret.txt") == secret_ + "\n", "secret.txt was changed");
  for (const fs::path& place : places_of_marks())
    require(!fs::exists(fs::symlink_status(place)), place.string() + " was written");

  require(::shmget(shared_key, 0, 0) < 0, "shared memory is left");
  require(::semget(shared_key, 0, 0) < 0, "semaphores are left");
  require(::msgget(shared_key, 0) < 0, "a queue of messages is left");
  require(::mq_unlink("/atelier-hostile") != 0, "a POSIX queue is left");
  for (const auto& entry : fs::directory_iterator(temporary_.path()))
    require(false, "left in the temporary folder: " + printable(entry.path().string()));
  require(project_state() == project_before_, "files of the project have changed");
  return changed;
}

}  // namespace atelier::test
