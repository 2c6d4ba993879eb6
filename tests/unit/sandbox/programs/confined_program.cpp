// What a stranger's program tries: confined_program ACTION [ARGUMENT ...]. Prints what has come of it.
#include <arpa/inet.h>
#include <fcntl.h>
#include <linux/io_uring.h>
#include <netinet/in.h>
#include <sched.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

extern char** environ;

namespace {

namespace fs = std::filesystem;
using Arguments = std::vector<std::string>;

std::string reason() {
  return strerrorname_np(errno);
}

void say(const std::string& line) {
  std::printf("%s\n", line.c_str());
  std::fflush(stdout);
}

void say_result(const std::string& what, bool done) {
  say(what + ": " + (done ? "done" : reason()));
}

void open_paths(const Arguments& paths) {
  for (const std::string& path : paths) say_result(path, ::open(path.c_str(), O_RDONLY) >= 0);
}

void write_files(const Arguments& paths) {
  for (const std::string& path : paths) say_result(path, ::open(path.c_str(), O_WRONLY | O_CREAT, 0600) >= 0);
}

void list_environment(const Arguments&) {
  for (char** entry = environ; *entry; ++entry) say(*entry);
}

void list_descriptors(const Arguments&) {
  for (int number = 0; number < 1024; ++number)
    if (::fcntl(number, F_GETFD) >= 0) say(std::to_string(number));
}

/// To a port of this machine, and to a name in the abstract namespace.
void connect_to(const Arguments& to) {
  const int port = ::socket(AF_INET, SOCK_STREAM, 0), name = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(std::uint16_t(std::stoi(to.at(0))));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  say_result("port", ::connect(port, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0);
  sockaddr_un path{};
  path.sun_family = AF_UNIX;
  std::memcpy(path.sun_path + 1, to.at(1).data(), to.at(1).size());
  const auto size = socklen_t(offsetof(sockaddr_un, sun_path) + 1 + to.at(1).size());
  say_result("name", ::connect(name, reinterpret_cast<sockaddr*>(&path), size) == 0);
}

void signal_processes(const Arguments& numbers) {
  for (const std::string& number : numbers) say_result("signal", ::kill(std::stoi(number), 0) == 0);
}

void list_processes(const Arguments&) {
  std::error_code error;
  for (fs::directory_iterator entry("/proc", error), end; !error && entry != end; entry.increment(error))
    if (const std::string name = entry->path().filename(); name.find_first_not_of("0123456789") == name.npos) say(name);
}

void tell_identity(const Arguments&) {
  say("user " + std::to_string(::geteuid()) + ", group " + std::to_string(::getegid()) + ", groups " +
      std::to_string(::getgroups(0, nullptr)));
  say("new privileges: " + std::to_string(::prctl(PR_GET_NO_NEW_PRIVS, 0, 0, 0, 0) == 0));
  say_result("root", ::setuid(0) == 0);
}

void call_the_kernel(const Arguments&) {
  const auto call = [](const char* name, auto... arguments) { say_result(name, ::syscall(long(arguments)...) >= 0); };
  io_uring_params parameters{};
  char bytes[8] = {};
  call("ptrace", SYS_ptrace, 0, 0, 0, 0);  // PTRACE_TRACEME
  call("unshare", SYS_unshare, CLONE_NEWUSER);
  call("clone", SYS_clone, CLONE_NEWUSER | SIGCHLD, 0, 0, 0, 0);
  call("mount", SYS_mount, "none", "/tmp", "tmpfs", 0, nullptr);
  call("io_uring", SYS_io_uring_setup, 4, &parameters);
  call("keyctl", SYS_keyctl, 0, -3, 1);
  call("process_vm_readv", SYS_process_vm_readv, ::getppid(), bytes, 0, bytes, 0, 0);
  call("userfaultfd", SYS_userfaultfd, 1);
  call("inotify_init1", SYS_inotify_init1, 0);
  call("inotify_add_watch", SYS_inotify_add_watch, 0, "/tmp", 1);
  call("bpf", SYS_bpf, 0, bytes, sizeof bytes);
  call("perf_event_open", SYS_perf_event_open, bytes, 0, -1, -1, 0);
  call("shmget", SYS_shmget, 0, 4096, 0600);
  call("memfd_create", SYS_memfd_create, "allowed", 0);
}

void take_memory(const Arguments& bytes) {
  const std::size_t size = std::stoull(bytes.at(0));
  void* taken = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  const bool done = taken != MAP_FAILED;
  if (done) std::memset(taken, 1, size);
  say_result("memory", done);
}

/// Writes files of 1 MiB, or one file, until no more fits.
void fill(const std::string& folder, std::size_t most, bool one_file) {
  ::signal(SIGXFSZ, SIG_IGN);
  const std::string block(1 << 20, 'x');
  std::size_t written = 0;
  int file = -1;
  for (int i = 0; written < most; ++i) {
    if (file < 0 || !one_file) {
      if (file >= 0) ::close(file);
      file = ::open((folder + "/" + std::to_string(i)).c_str(), O_WRONLY | O_CREAT, 0600);
    }
    const ssize_t got = ::write(file, block.data(), block.size());
    if (got <= 0) break;
    written += std::size_t(got);
  }
  say(std::to_string(written >> 20) + " MiB");
}

void start_processes(const Arguments& most) {
  int started = 0;
  for (int child = 1; started < std::stoi(most.at(0)) && child > 0; started += child > 0)
    if ((child = ::fork()) == 0) {
      ::sleep(20);
      ::_exit(0);
    }
  say(std::to_string(started) + " processes");
}

/// A grandchild in a session of its own, which no signal to our group reaches and which outlives us.
void leave_process(bool stays) {
  if (::fork() == 0) {
    ::setsid();
    if (::fork() != 0) ::_exit(0);
    ::prctl(PR_SET_PDEATHSIG, 0, 0, 0, 0);
    say("left");
    for (int number = 1; number < 32; ++number) ::signal(number, SIG_IGN);
    ::sleep(60);
    ::_exit(0);
  }
  ::usleep(200'000);
  while (stays) ::pause();
}

/// Folders that only their owner could enter, if he had not taken that right from himself.
void leave_locked_folders(const Arguments& folder) {
  const fs::path locked = fs::path(folder.empty() ? std::getenv("TMPDIR") : folder[0]) / "locked";
  fs::create_directories(locked / "inner");
  std::fclose(std::fopen((locked / "inner/file").c_str(), "w"));
  ::chmod((locked / "inner").c_str(), 0), ::chmod(locked.c_str(), 0);
  say_result("locked", true);
}

void answer(const Arguments& words) {
  std::FILE* file = std::fopen((words.at(0) + "/answer").c_str(), "w");
  if (file) std::fputs(words.at(1).c_str(), file), std::fclose(file);
  say_result("answer", file != nullptr);
}

void end_by_signal(const Arguments& number) {
  ::signal(std::stoi(number.at(0)), SIG_DFL);
  ::raise(std::stoi(number.at(0)));
}

}  // namespace

int main(int count, char** texts) {
  const std::map<std::string, std::function<void(const Arguments&)>> actions = {
      {"open", open_paths},
      {"write", write_files},
      {"environment", list_environment},
      {"descriptors", list_descriptors},
      {"connect", connect_to},
      {"signal", signal_processes},
      {"processes", list_processes},
      {"identity", tell_identity},
      {"kernel", call_the_kernel},
      {"memory", take_memory},
      {"fill-file", [](const Arguments& a) { fill(a.at(0), std::stoull(a.at(1)), true); }},
      {"fill-files", [](const Arguments& a) { fill(a.at(0), std::stoull(a.at(1)), false); }},
      {"fill-tmp", [](const Arguments& a) { fill(std::getenv("TMPDIR"), std::stoull(a.at(0)), false); }},
      {"fork", start_processes},
      {"leave", [](const Arguments&) { leave_process(false); }},
      {"leave-and-stay", [](const Arguments&) { leave_process(true); }},
      {"lock", leave_locked_folders},
      {"answer", answer},
      {"exit", [](const Arguments& a) { std::exit(std::stoi(a.at(0))); }},
      {"raise", end_by_signal},
  };
  const auto action = count < 2 ? actions.end() : actions.find(texts[1]);
  if (action == actions.end()) return 99;
  action->second(Arguments(texts + 2, texts + count));
}
