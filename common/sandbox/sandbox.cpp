#include "sandbox/sandbox.hpp"

#include <dirent.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstring>
#include <set>
#include <thread>

#include "base/error.hpp"
#include "base/printable.hpp"
#include "base/system_reason.hpp"

namespace atelier::sandbox {
namespace {

namespace fs = std::filesystem;

constexpr const char* bubblewrap = "/usr/bin/bwrap";
constexpr int socket_number = 4;  ///< of atelier-confine's reports
constexpr int start_limit_ms = 10'000;

/// Accounts that no distribution gives to people or services (Debian Policy 9.2.2), and that containers have too. Each
/// sandbox takes one.
constexpr uid_t first_account = 65'000, last_account = 65'499;

/// The helper stands beside the libraries of this program, in ../lib.
fs::path confine_program() {
  std::error_code error;
  const fs::path here = fs::read_symlink("/proc/self/exe", error);
  for (const fs::path& folder : {here.parent_path().parent_path() / "lib", here.parent_path() / "lib"})
    if (fs::exists(folder / "atelier-confine", error)) return folder / "atelier-confine";
  throw Error(fmt::format("the program atelier-confine is missing beside {}; build the project again", here.string()));
}

/// The accounts under which something runs.
std::set<uid_t> busy_accounts() {
  std::set<uid_t> busy;
  std::error_code error;
  for (fs::directory_iterator entry("/proc", error), end; !error && entry != end; entry.increment(error)) {
    struct stat status {};
    const std::string name = entry->path().filename().string();
    if (name.find_first_not_of("0123456789") == name.npos && ::stat(entry->path().c_str(), &status) == 0)
      busy.insert(status.st_uid);
  }
  return busy;
}

/// Holds an account against every other grader: the kernel gives the name of a socket to one process, until that closes
/// it. None if another one has it.
Descriptor reserve(uid_t account) {
  const std::string name = fmt::format("atelier-account-{}", account);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::memcpy(address.sun_path + 1, name.data(), name.size());  // behind NUL: no file
  Descriptor held(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
  const auto size = socklen_t(offsetof(sockaddr_un, sun_path) + 1 + name.size());
  return ::bind(held.get(), reinterpret_cast<const sockaddr*>(&address), size) == 0 ? std::move(held) : Descriptor();
}

/// Folders of the system that a program needs to be loaded and to draw, or a compiler to compile.
std::vector<fs::path> system_paths() {
  return {"/usr", "/etc/ld.so.cache", "/etc/alternatives", "/etc/drirc"};
}

/// The folders around these paths, outermost first, which bubblewrap would make for root alone.
void add_folders_around(std::vector<std::string>& arguments, const std::vector<fs::path>& paths) {
  std::set<fs::path> folders;
  for (const fs::path& path : paths)
    for (fs::path folder = path.parent_path(); folder != folder.root_path(); folder = folder.parent_path())
      folders.insert(folder);
  for (const fs::path& folder : folders)
    arguments.insert(arguments.end(), {"--perms", "0755", "--dir", folder.string()});
}

/// /lib -> usr/lib, where distributions have merged them; otherwise folders.
void add_root_folders(std::vector<std::string>& arguments) {
  for (const char* folder : {"/bin", "/sbin", "/lib", "/lib32", "/lib64", "/libx32"}) {
    std::error_code error;
    if (fs::is_symlink(folder, error))
      arguments.insert(arguments.end(), {"--symlink", fs::read_symlink(folder, error).string(), folder});
    else if (fs::is_directory(folder, error))
      arguments.insert(arguments.end(), {"--ro-bind", folder, folder});
  }
}

void add_limits(std::vector<std::string>& arguments, const Limits& limits) {
  arguments.insert(arguments.end(),
                   {"--memory", std::to_string(limits.memory), "--file", std::to_string(limits.file), "--processes",
                    std::to_string(limits.processes), "--seconds", std::to_string(limits.processor_seconds)});
}

/// The paths that exist. In the file system of its own, a path leads where it leads here.
std::vector<std::string> existing(const std::vector<fs::path>& paths) {
  std::vector<std::string> found;
  std::error_code error;
  for (const fs::path& path : paths)
    if (fs::exists(path, error)) found.push_back(path.string());
  return found;
}

}  // namespace

Sandbox::Sandbox(Tier tier, const Limits& limits) : tier_(tier), limits_(limits) {
  if (tier == Tier::none) return;
  if (tier == Tier::full && ::access(bubblewrap, X_OK) != 0)
    throw Error("the program bwrap is not there: install the package bubblewrap");
  if (tier == Tier::account && ::geteuid() != 0) throw Error("only root can start programs under another account");
  if (::geteuid() != 0) return;
  take_account();
  if (tier == Tier::account) {
    scratch_.emplace("atelier-scratch");
    give(scratch_->held().create_folder("tmp").path());
  }
  group_ = ControlGroup::create(std::to_string(*account_), limits.memory, limits.processes);
}

/// An account under which nothing runs, and that no other sandbox has.
void Sandbox::take_account() {
  static std::atomic<uid_t> taken{0};  // another one each time
  constexpr uid_t count = last_account - first_account + 1;
  const std::set<uid_t> busy = busy_accounts();
  for (uid_t tried = 0; tried < count; ++tried) {
    const uid_t account = first_account + (uid_t(::getpid()) * 16 + taken++) % count;
    if (busy.contains(account) || !(reservation_ = reserve(account))) continue;
    account_ = account;
    return;
  }
  throw Error(fmt::format("the sandbox has no free account: all of {}..{} are in use", first_account, last_account));
}

Sandbox::~Sandbox() {
  kill_all();
}

/// In a file system of its own, the folder of answers is there alone.
bool Sandbox::sends_answers(const Room& room) const {
  return tier_ == Tier::full && !room.answers.empty();
}

std::vector<std::string> Sandbox::inner_arguments(const Room& room) const {
  std::vector<std::string> arguments = {confine_program().string()};
  if (account_) arguments.insert(arguments.end(), {"--account", std::to_string(*account_)});
  add_limits(arguments, room.limits);
  arguments.insert(arguments.end(), {"--report", std::to_string(socket_number)});
  if (sends_answers(room)) arguments.insert(arguments.end(), {"--send", room.answers.string()});
  if (tier_ == Tier::account) {
    std::vector<fs::path> readable = system_paths(), writable = room.writable;
    for (const char* path : {"/lib", "/lib32", "/lib64", "/libx32", "/bin", "/dev/null", "/dev/zero", "/dev/urandom"})
      readable.push_back(path);
    readable.insert(readable.end(), room.readable.begin(), room.readable.end());
    writable.push_back("/dev/null");
    if (!room.answers.empty()) writable.push_back(room.answers);
    writable.push_back(scratch_->path() / "tmp");
    for (const std::string& path : existing(readable)) arguments.insert(arguments.end(), {"--read", path});
    for (const std::string& path : existing(writable)) arguments.insert(arguments.end(), {"--write", path});
  }
  arguments.insert(arguments.end(), {"--filter", "--"});
  return arguments;
}

std::vector<std::string> Sandbox::outer_arguments(const Launch& wanted, const Room& room) const {
  std::vector<std::string> arguments;
  if (group_) {
    arguments.push_back(confine_program().string());
    for (const fs::path& folder : group_->folders()) arguments.insert(arguments.end(), {"--cgroup", folder.string()});
    arguments.push_back("--");
  }
  if (tier_ != Tier::full) return arguments;
  const auto add = [&](std::initializer_list<std::string> more) { arguments.insert(arguments.end(), more); };
  add({bubblewrap, "--unshare-pid", "--unshare-net", "--unshare-ipc", "--unshare-uts", "--unshare-cgroup-try",
       "--die-with-parent", "--new-session"});
  if (account_)  // the capabilities with which atelier-confine gives up the rest
    add({"--cap-drop", "ALL", "--cap-add", "CAP_SETUID", "--cap-add", "CAP_SETGID"});
  else
    add({"--unshare-user"});
  add({"--size", std::to_string(room.limits.scratch), "--perms", "1777", "--tmpfs", "/tmp"});
  std::vector<fs::path> readable = system_paths();
  readable.push_back(confine_program());
  readable.insert(readable.end(), room.readable.begin(), room.readable.end());
  std::vector<fs::path> all = readable;
  all.insert(all.end(), room.writable.begin(), room.writable.end());
  if (!room.answers.empty()) all.push_back(room.answers);
  add_folders_around(arguments, all);
  add_root_folders(arguments);
  add({"--proc", "/proc", "--dev", "/dev", "--remount-ro", "/dev"});
  for (const std::string& path : existing(readable)) add({"--ro-bind", path, path});
  for (const fs::path& path : room.writable) add({"--bind", path.string(), path.string()});
  if (!room.answers.empty())
    add({"--size", std::to_string(room.answers_bytes), "--perms", "0777", "--tmpfs", room.answers.string()});
  add({"--remount-ro", "/", "--chdir", wanted.folder.empty() ? "/" : wanted.folder.string(), "--"});
  return arguments;
}

Confined Sandbox::confine(const Launch& wanted, const Room& room) const {
  Confined confined;
  confined.launch = wanted;
  if (tier_ == Tier::none) {
    ++running_;
    return confined;
  }
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    throw Error("the sandbox cannot create a socket: " + system_reason());
  confined.ours = Descriptor(ends[0]), confined.theirs = Descriptor(ends[1]);
  confined.launch.descriptors.push_back({confined.theirs.get(), socket_number});
  confined.sends_answers = sends_answers(room);
  std::map<std::string, std::string>& environment =
      confined.launch.environment.emplace(wanted.environment.value_or(std::map<std::string, std::string>()));
  environment["HOME"] = environment["TMPDIR"] = scratch_ ? (scratch_->path() / "tmp").string() : "/tmp";
  std::vector<std::string> arguments = outer_arguments(wanted, room);
  const std::vector<std::string> inner = inner_arguments(room);
  arguments.insert(arguments.end(), inner.begin(), inner.end());
  arguments.push_back(find_program(wanted.arguments.at(0)).string());
  arguments.insert(arguments.end(), wanted.arguments.begin() + 1, wanted.arguments.end());
  confined.launch.arguments = std::move(arguments);
  if (tier_ == Tier::full) confined.launch.folder.clear();  // bubblewrap goes there
  ++running_;
  return confined;
}

bool Confined::receive_answers(Descriptor& answers) {
  theirs.reset();
  if (!sends_answers) return true;
  pollfd wait{ours.get(), POLLIN, 0};
  if (::poll(&wait, 1, start_limit_ms) != 1) return false;
  char byte = 0;
  iovec bytes{&byte, 1};
  alignas(cmsghdr) char control[CMSG_SPACE(sizeof(int))] = {};
  msghdr message{};
  message.msg_iov = &bytes;
  message.msg_iovlen = 1;
  message.msg_control = control;
  message.msg_controllen = sizeof control;
  if (::recvmsg(ours.get(), &message, MSG_CMSG_CLOEXEC) != 1) return false;
  ++reports;
  for (cmsghdr* header = CMSG_FIRSTHDR(&message); header; header = CMSG_NXTHDR(&message, header))
    if (header->cmsg_level == SOL_SOCKET && header->cmsg_type == SCM_RIGHTS) {
      int folder = -1;
      std::memcpy(&folder, CMSG_DATA(header), sizeof folder);
      answers = Descriptor(folder);
    }
  return bool(answers);
}

bool Confined::was_started() {
  if (!ours) return true;
  for (char byte = 0; reports < 2 && ::recv(ours.get(), &byte, 1, MSG_DONTWAIT) == 1;) ++reports;
  return reports == 1;
}

void Sandbox::let_through(const fs::path& folder) const {
  if (account_ && ::chmod(folder.c_str(), 0711) != 0)
    throw Error(fmt::format("{}: cannot be opened to the sandbox: {}", folder.string(), system_reason()));
}

void Sandbox::give(const fs::path& folder) const {
  if (!account_) return;
  if (::chown(folder.c_str(), *account_, *account_) != 0)
    throw Error(fmt::format("{}: cannot be given to the sandbox: {}", folder.string(), system_reason()));
  let_through(folder.parent_path());
}

void Sandbox::program_ended() const {
  if (--running_ == 0) kill_all();
}

/// Namespaces end with their first process; without them a process may have left its group. Those that are still about
/// to end count as processes of the next program.
void Sandbox::kill_all() const {
  if (tier_ == Tier::account) kill_account();
  if (group_) group_->kill_all();
}

void Sandbox::kill_account() const {
  for (int round = 0; round < 250; ++round) {  // half a second: init may be slow to reap an orphan
    // Only a process of the same account may, and -1 means all of them.
    const pid_t killer = ::fork();
    if (killer == 0) {
      if (::setresuid(*account_, *account_, *account_) == 0) ::kill(-1, SIGKILL);
      ::_exit(0);
    }
    while (killer > 0 && ::waitpid(killer, nullptr, 0) < 0 && errno == EINTR) {
    }
    if (!busy_accounts().contains(*account_)) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

int Sandbox::memory_kills() const {
  return group_ ? group_->memory_kills() : 0;
}

std::string in_words(std::size_t bytes) {
  constexpr std::size_t giga = std::size_t(1) << 30;
  return bytes % giga == 0 ? fmt::format("{} GiB", bytes / giga) : fmt::format("{} MiB", bytes >> 20);
}

int signal_of_status(int status) {
  return status > 128 && status < 128 + 65 ? status - 128 : 0;
}

std::string failure_of_sandbox(const std::string& output) {
  const std::string line = shorten(printable(output.substr(0, output.find('\n'))), 300);
  return line.empty() ? "it says nothing" : line;
}

}  // namespace atelier::sandbox
