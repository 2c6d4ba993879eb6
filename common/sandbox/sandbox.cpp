#include "sandbox/sandbox.hpp"

#include <dirent.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <set>

#include "base/error.hpp"
#include "base/printable.hpp"
#include "base/system_reason.hpp"

namespace atelier::sandbox {
namespace {

namespace fs = std::filesystem;

constexpr const char* bubblewrap = "/usr/bin/bwrap";
constexpr int socket_number = 4;  ///< of the socket for the folder of answers, in the program
constexpr int answers_limit_ms = 10'000;

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

/// An account for one sandbox: of no running program, and not taken by this process before, as far as there are any.
uid_t free_account() {
  static std::atomic<uid_t> taken{0};
  constexpr uid_t count = last_account - first_account + 1;
  const std::set<uid_t> busy = busy_accounts();
  for (uid_t tried = 0; tried < count; ++tried) {
    const uid_t account = first_account + (uid_t(::getpid()) * 16 + taken++) % count;
    if (!busy.contains(account)) return account;
  }
  throw Error(
      fmt::format("the sandbox has no free account: programs run under all of {}..{}", first_account, last_account));
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
  account_ = free_account();
  if (tier == Tier::account) {
    scratch_.emplace("atelier-scratch");
    give(scratch_->held().create_folder("tmp").path());
  }
  group_ = ControlGroup::create(std::to_string(*account_), limits.memory, limits.processes);
}

Sandbox::~Sandbox() {
  kill_account();
}

std::vector<std::string> Sandbox::inner_arguments(const Room& room, int socket) const {
  std::vector<std::string> arguments = {confine_program().string()};
  if (account_) arguments.insert(arguments.end(), {"--account", std::to_string(*account_)});
  add_limits(arguments, room.limits);
  if (socket >= 0) arguments.insert(arguments.end(), {"--send", std::to_string(socket_number), room.answers.string()});
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
  ++running_;
  if (tier_ == Tier::none) return confined;
  if (tier_ == Tier::full && !room.answers.empty()) {
    int ends[2];
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
      throw Error("the sandbox cannot create a socket: " + system_reason());
    confined.ours = Descriptor(ends[0]), confined.theirs = Descriptor(ends[1]);
    confined.launch.descriptors.push_back({confined.theirs.get(), socket_number});
  }
  std::map<std::string, std::string>& environment =
      confined.launch.environment.emplace(wanted.environment.value_or(std::map<std::string, std::string>()));
  environment["HOME"] = environment["TMPDIR"] = scratch_ ? (scratch_->path() / "tmp").string() : "/tmp";
  std::vector<std::string> arguments = outer_arguments(wanted, room);
  const std::vector<std::string> inner = inner_arguments(room, confined.theirs.get());
  arguments.insert(arguments.end(), inner.begin(), inner.end());
  arguments.push_back(find_program(wanted.arguments.at(0)).string());
  arguments.insert(arguments.end(), wanted.arguments.begin() + 1, wanted.arguments.end());
  confined.launch.arguments = std::move(arguments);
  if (tier_ == Tier::full) confined.launch.folder.clear();  // bubblewrap goes there
  return confined;
}

Descriptor Confined::receive_answers() {
  theirs.reset();
  pollfd wait{ours.get(), POLLIN, 0};
  const bool came = ::poll(&wait, 1, answers_limit_ms) == 1;
  char byte = 0;
  iovec bytes{&byte, 1};
  alignas(cmsghdr) char control[CMSG_SPACE(sizeof(int))] = {};
  msghdr message{};
  message.msg_iov = &bytes;
  message.msg_iovlen = 1;
  message.msg_control = control;
  message.msg_controllen = sizeof control;
  if (came && ::recvmsg(ours.get(), &message, MSG_CMSG_CLOEXEC) == 1)
    for (cmsghdr* header = CMSG_FIRSTHDR(&message); header; header = CMSG_NXTHDR(&message, header))
      if (header->cmsg_level == SOL_SOCKET && header->cmsg_type == SCM_RIGHTS) {
        int folder = -1;
        std::memcpy(&folder, CMSG_DATA(header), sizeof folder);
        ours.reset();
        return Descriptor(folder);
      }
  throw Error("the sandbox did not start a program: its folder of answers did not come");
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
  if (--running_ == 0) kill_account();
}

/// Namespaces end with their first process; without them a process may have left its group.
void Sandbox::kill_account() const {
  if (tier_ != Tier::account || !account_) return;
  // Only a process of the same account may, and -1 means all of them.
  const pid_t killer = ::fork();
  if (killer == 0) {
    if (::setresuid(*account_, *account_, *account_) == 0) ::kill(-1, SIGKILL);
    ::_exit(0);
  }
  if (killer > 0)
    while (::waitpid(killer, nullptr, 0) < 0 && errno == EINTR) {
    }
}

bool Sandbox::ran_out_of_memory() const {
  return group_ && group_->ran_out_of_memory();
}

int signal_of_status(int status) {
  return status > 128 && status < 128 + 65 ? status - 128 : 0;
}

std::string failure_of_sandbox(const std::string& output) {
  for (const char* program : {"bwrap: ", "atelier-confine: "})
    if (output.starts_with(program)) return shorten(printable(output.substr(0, output.find('\n'))), 300);
  return "";
}

}  // namespace atelier::sandbox
