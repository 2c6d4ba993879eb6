// atelier-confine: gives up rights, one after the other in the order below, and becomes another program.
//
//   atelier-confine [OPTION ...] -- PROGRAM [ARGUMENT ...]
//
//   --cgroup DIR        enter a control group
//   --account N         become the user and the group N, in no other group
//   --memory BYTES      of address space, --file BYTES of one file, --processes N, --seconds N of processor time
//   --report N          send one byte through the socket N just before PROGRAM starts, and another if it does not
//   --send DIR          with the first byte, send the folder DIR
//   --read PATH         with --write PATH: no other file or folder can be reached (Landlock)
//   --filter            refuse dangerous system calls (system_calls.hpp)
//
// It never gains rights: no program that it starts does, not even one with a set-user-ID bit. Exits with 126 and one
// line on stderr that begins with "atelier-confine: " if anything of this fails.
#include <errno.h>
#include <fcntl.h>
#include <grp.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "file_access.hpp"
#include "system_calls.hpp"

namespace atelier::confine {
namespace {

[[noreturn]] void fail(const std::string& what, int reason = errno) {
  std::fprintf(stderr, "atelier-confine: %s: %s\n", what.c_str(), std::strerror(reason));
  std::_Exit(126);
}

struct Limit {
  int resource;
  rlim_t value;
};

struct Options {
  std::vector<std::string> groups, readable, writable;
  std::vector<Limit> limits;
  long account = -1;
  int socket = -1;
  std::string sent;
  bool filter = false, restricts_files = false;
  char** program = nullptr;
};

rlim_t number(const char* text) {
  char* end = nullptr;
  errno = 0;
  const unsigned long long value = std::strtoull(text, &end, 10);
  if (errno != 0 || end == text || *end != '\0') fail(std::string("not a number: ") + text, EINVAL);
  return value;
}

Options parse(char** argument) {
  Options options;
  const auto next = [&]() -> const char* {
    if (!*++argument) fail("a value is missing at the end", EINVAL);
    return *argument;
  };
  for (; *argument; ++argument) {
    const std::string option = *argument;
    if (option == "--") {
      options.program = argument + 1;
      break;
    } else if (option == "--cgroup") {
      options.groups.push_back(next());
    } else if (option == "--account") {
      options.account = long(number(next()));
    } else if (option == "--memory") {
      options.limits.push_back({RLIMIT_AS, number(next())});
    } else if (option == "--file") {
      options.limits.push_back({RLIMIT_FSIZE, number(next())});
    } else if (option == "--processes") {
      options.limits.push_back({RLIMIT_NPROC, number(next())});
    } else if (option == "--seconds") {
      options.limits.push_back({RLIMIT_CPU, number(next())});
    } else if (option == "--report") {
      options.socket = int(number(next()));
    } else if (option == "--send") {
      options.sent = next();
    } else if (option == "--read") {
      options.readable.push_back(next());
      options.restricts_files = true;
    } else if (option == "--write") {
      options.writable.push_back(next());
      options.restricts_files = true;
    } else if (option == "--filter") {
      options.filter = true;
    } else {
      fail("unknown option " + option, EINVAL);
    }
  }
  if (!options.program || !*options.program) fail("no program after --", EINVAL);
  return options;
}

void enter(const std::string& group) {
  const std::string file = group + "/cgroup.procs";
  const int procs = ::open(file.c_str(), O_WRONLY | O_CLOEXEC);
  if (procs < 0 || ::write(procs, "0", 1) != 1) fail(file);
  ::close(procs);
}

int open_folder(const std::string& path) {
  const int folder = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (folder < 0) fail(path);
  return folder;
}

/// A descriptor travels as "ancillary data" of a message (unix(7), SCM_RIGHTS); -1: none.
void report(int socket, int folder = -1) {
  char byte = 0;
  iovec bytes{&byte, 1};
  alignas(cmsghdr) char control[CMSG_SPACE(sizeof(int))] = {};
  msghdr message{};
  message.msg_iov = &bytes;
  message.msg_iovlen = 1;
  if (folder >= 0) {
    message.msg_control = control;
    message.msg_controllen = sizeof control;
    cmsghdr* header = CMSG_FIRSTHDR(&message);
    header->cmsg_level = SOL_SOCKET;
    header->cmsg_type = SCM_RIGHTS;
    header->cmsg_len = CMSG_LEN(sizeof(int));
    std::memcpy(CMSG_DATA(header), &folder, sizeof folder);
  }
  if (::sendmsg(socket, &message, MSG_NOSIGNAL) != 1) fail("the start cannot be reported");
}

void limit(const Limit& wanted) {
  rlimit now{};
  ::getrlimit(__rlimit_resource(wanted.resource), &now);
  const rlim_t value = wanted.value < now.rlim_max ? wanted.value : now.rlim_max;
  const rlimit both{value, value};
  if (::setrlimit(__rlimit_resource(wanted.resource), &both) != 0) fail("a limit cannot be set");
}

/// Also gives up all capabilities: a process that leaves root's account for good has none, and without new privileges
/// it gets none.
void become(long account) {
  const auto id = static_cast<uid_t>(account);
  if (::setgroups(0, nullptr) != 0 || ::setresgid(id, id, id) != 0 || ::setresuid(id, id, id) != 0)
    fail("the account cannot be changed");
  if (::setuid(0) == 0) fail("the account was not given up", EPERM);
}

[[noreturn]] void run(const Options& options) {
  for (const std::string& group : options.groups) enter(group);
  if (options.account >= 0) become(options.account);
  limit({RLIMIT_CORE, 0});
  for (const Limit& each : options.limits) limit(each);
  const int folder = options.sent.empty() ? -1 : open_folder(options.sent);
  if (options.socket >= 0) ::fcntl(options.socket, F_SETFD, FD_CLOEXEC);
  const bool gives_up = options.filter || options.restricts_files;
  if (gives_up && ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) fail("new privileges cannot be given up");
  if (options.restricts_files && !restrict_files(options.readable, options.writable))
    fail("the access to files cannot be restricted");
  if (options.filter && !refuse_system_calls()) fail("system calls cannot be filtered");
  // A change of account has reset this: end with the program that started us.
  if (::prctl(PR_SET_PDEATHSIG, 9, 0, 0, 0) != 0) fail("the end cannot be tied to the grader's");
  if (options.socket >= 0) report(options.socket, folder);
  ::execv(options.program[0], options.program);
  const int reason = errno;
  if (options.socket >= 0) report(options.socket);
  fail(options.program[0], reason);
}

}  // namespace
}  // namespace atelier::confine

int main(int, char** arguments) {
  atelier::confine::run(atelier::confine::parse(arguments + 1));
}
