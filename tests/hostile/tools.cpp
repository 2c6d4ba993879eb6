// What hostile fragments share. tests/steps/hostile.cpp puts this text, then the fragment, in front of the student's
// file; so each is compiled as a part of what a student hands in, with only the headers that a student may include.
//
// A fragment says on its output that it tries (attempted), and what it has reached (breached). The test requires the
// first and forbids the second, in every file of the results.
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

extern "C" void* dlsym(void*, const char*) noexcept;

namespace hostile {

// ---- The system

/// A function of the C library by its name: <unistd.h> and the like are refused.
template <class Result = long, class... Arguments>
inline Result libc(const char* name, Arguments... arguments) {
  void* found = dlsym(nullptr, name);
  if (!found) return Result(-1);
  return reinterpret_cast<Result (*)(Arguments...)>(found)(arguments...);
}

// As Linux has them on x86-64 and on AArch64.
[[maybe_unused]] constexpr int read_only = 0, write_only = 1, create = 0100, truncate = 01000;
#if defined(__aarch64__)
[[maybe_unused]] constexpr int folder_only = 040000;
#else
[[maybe_unused]] constexpr int folder_only = 0200000;
#endif
[[maybe_unused]] constexpr int signal_kill = 9, signal_term = 15, signal_cont = 18, signal_stop = 19;

#if defined(__aarch64__)
enum : long { sys_ptrace = 117, sys_add_key = 217, sys_keyctl = 219, sys_mount = 40, sys_unshare = 97, sys_bpf = 280 };
enum : long { sys_pidfd_getfd = 438, sys_process_vm_readv = 270, sys_perf_event_open = 241, sys_userfaultfd = 282 };
enum : long { sys_memfd_create = 279 };
#else
enum : long {
  sys_ptrace = 101,
  sys_add_key = 248,
  sys_keyctl = 250,
  sys_mount = 165,
  sys_unshare = 272,
  sys_bpf = 321
};
enum : long { sys_pidfd_getfd = 438, sys_process_vm_readv = 310, sys_perf_event_open = 298, sys_userfaultfd = 323 };
enum : long { sys_memfd_create = 319 };
#endif
enum : long { sys_io_uring_setup = 425, sys_pidfd_open = 434 };

template <class... Arguments>
inline long system_call(long number, Arguments... arguments) {
  return libc<long>("syscall", number, long(arguments)...);
}

inline int open(const std::string& path, int flags = read_only, int mode = 0644) {
  return libc<int>("open", path.c_str(), flags, mode);
}
inline void close(int file) {
  libc<int>("close", file);
}
inline long write(int file, const void* bytes, std::size_t count) {
  return libc<long>("write", file, bytes, count);
}
inline void sleep(unsigned seconds) {
  libc<unsigned>("sleep", seconds);
}
inline long seconds_now() {
  return libc<long>("time", static_cast<long*>(nullptr));
}
/// Whatever else happens, this process ends by itself.
inline void end_after(unsigned seconds) {
  libc<unsigned>("alarm", seconds);
}
inline int fork() {
  return libc<int>("fork");
}
[[noreturn]] inline void leave(int status) {
  libc<int>("_exit", status);
  std::abort();
}

inline std::string read_from(int file, std::size_t limit = 1 << 16) {
  std::string text;
  char block[4096];
  while (text.size() < limit) {
    const long got = libc<long>("read", file, static_cast<void*>(block), sizeof block);
    if (got <= 0) break;
    text.append(block, std::size_t(got));
  }
  return text;
}
inline std::string read_file(const std::string& path, std::size_t limit = 1 << 16) {
  const int file = open(path, read_only | 04000);  // O_NONBLOCK: a FIFO must not hold us
  if (file < 0) return "";
  const std::string text = read_from(file, limit);
  close(file);
  return text;
}
inline bool write_file(const std::string& path, const std::string& text) {
  const int file = open(path, write_only | create | truncate);
  if (file < 0) return false;
  const bool done = write(file, text.data(), text.size()) == long(text.size());
  close(file);
  return done;
}
inline bool exists(const std::string& path) {
  return libc<int>("access", path.c_str(), 0) == 0;
}

/// Names of entries, without . and ..; of at most `limit`.
inline std::vector<std::string> entries(const std::string& folder, std::size_t limit = 5000) {
  std::vector<std::string> names;
  void* stream = libc<void*>("opendir", folder.c_str());
  if (!stream || stream == reinterpret_cast<void*>(-1)) return names;
  // struct dirent of 64-bit Linux: ino, off, reclen (2 bytes), type (1 byte), name
  for (char* entry; names.size() < limit && (entry = libc<char*>("readdir", stream)) != nullptr;) {
    const std::string name = entry + 19;
    if (name != "." && name != "..") names.push_back(name);
  }
  libc<int>("closedir", stream);
  return names;
}

/// Runs `action` in a child that ends after 20 s at the latest, so that its death or its hanging costs us nothing.
/// Returns waitpid's status; -1 if there is no child.
template <class Action>
inline int in_child(Action action) {
  const int child = fork();
  if (child == 0) {
    end_after(20);
    action();
    leave(0);
  }
  int status = -1;
  if (child > 0) libc<int>("waitpid", child, &status, 0);
  return status;
}

// ---- What the test has laid out

inline const std::string canary = "/tmp/atelier-canary";        ///< a folder that everybody may write to
inline const std::string secret_file = canary + "/secret.txt";  ///< its only line must be in no result
inline const std::string honest_mark =
    std::string("written by ") + "the honest one";  ///< in the submission beside ours
[[maybe_unused]] constexpr int canary_port = 47811;
inline const std::string canary_process = "atelier-canary-process";

// ---- What the test looks for

inline void say(const std::string& text) {
  write(1, text.data(), text.size());
}
/// In two pieces, so that a compiler that shows this line does not show the word.
inline const std::string word_of_success = std::string("brea") + "ched: ";

inline void attempted(const std::string& name) {
  say("attempted: " + name + "\n");
}
inline std::string& reached() {
  static std::string text;
  return text;
}
inline void breached(const std::string& what) {
  reached() += word_of_success + what + "\n";
  say(word_of_success + what + "\n");
}
/// Says so if there is something in `text`: what has been read where nothing must be.
inline void breached_if_any(const std::string& what, const std::string& text) {
  if (!text.empty()) breached(what + ": " + text.substr(0, 300));
}
/// The other way into a report.
inline void throw_what_was_reached() {
  if (!reached().empty()) throw std::runtime_error(reached());
}
/// A file that the test finds afterwards, where the program may write outside.
inline void leave_mark(const std::string& name) {
  write_file(canary + "/written-" + name, name + "\n");
}

// ---- The program that we are in

// Written before any object of this library exists.
inline int start_count = 0;
inline char **start_arguments = nullptr, **start_environment = nullptr;

inline std::vector<std::string> command_line() {
  return {start_arguments, start_arguments + start_count};
}
inline std::string option(const std::string& name) {
  for (int i = 0; i + 1 < start_count; ++i)
    if (start_arguments[i] == name) return start_arguments[i + 1];
  return "";
}
inline std::string answers() {
  return option("--out");
}
inline int progress() {
  const std::string number = option("--progress");
  return number.empty() ? 3 : std::atoi(number.c_str());
}
/// Names of the cases of our job, and whether each is a probe.
struct Asked {
  std::string name;
  bool probe = false;
};
inline std::vector<Asked> asked_cases() {
  std::vector<Asked> cases;
  const std::string job = read_file(option("--cases"), 1 << 22), key = "\"name\": \"";
  for (std::size_t at = job.find(key); at != job.npos;) {
    const std::size_t begin = at + key.size(), end = job.find('"', begin);
    if (end == job.npos) break;
    at = job.find(key, end);
    // Members are in the order of their names, so this case's probe stands between its name and the next one.
    cases.push_back({job.substr(begin, end - begin), job.substr(end, at - end).find("\"probe\": \"") != job.npos});
  }
  return cases;
}
inline void tell_judge(const std::string& line) {
  write(progress(), line.data(), line.size());
}

}  // namespace hostile

/// The loader of glibc passes what main gets.
__attribute__((constructor(101))) static void hostile_remember(int count, char** arguments, char** variables) {
  hostile::start_count = count;
  hostile::start_arguments = arguments;
  hostile::start_environment = variables;
}

/// Runs when the library is loaded, before any case.
#define HOSTILE_START                                              \
  static void hostile_start();                                     \
  static const bool hostile_has_started = (hostile_start(), true); \
  static void hostile_start()
