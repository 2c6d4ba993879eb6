#include "app/crash.hpp"

#include <dlfcn.h>
#include <execinfo.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>

namespace atelier {

namespace {

// A signal handler must not allocate or lock: the crash may have happened in malloc.

#if defined(__SANITIZE_ADDRESS__)
constexpr bool sanitizer_reports = true;
#else
constexpr bool sanitizer_reports = false;
#endif
constexpr int crashes[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL};
constexpr std::size_t alternate_stack = 64 << 10;  // bytes; backtrace needs 8 kB
constexpr int most_frames = 64;                    // infinite recursion has thousands of equal frames

/// A message that is assembled in a fixed buffer and written at once.
struct Line {
  std::array<char, 512> text{};
  std::size_t size = 0;
  void add(std::string_view piece) {
    const std::size_t taken = std::min(piece.size(), text.size() - size);
    std::memcpy(text.data() + size, piece.data(), taken);
    size += taken;
  }
};

/// "01-transforms" from ".../01-transforms/libstep.so"; empty for any other library.
std::string_view step_of(std::string_view library) {
  constexpr std::string_view ending = "/libstep.so";
  if (!library.ends_with(ending)) return {};
  library.remove_suffix(ending.size());
  return library.substr(library.rfind('/') + 1);
}

void report_function(int number) {
  void* frames[most_frames];
  const int count = ::backtrace(frames, most_frames);
  for (int i = 0; i < count; ++i) {
    Dl_info found{};
    if (::dladdr(frames[i], &found) == 0 || !found.dli_fname || !found.dli_sname) continue;
    const std::string_view step = step_of(found.dli_fname);
    char name[256];
    const std::size_t length = step.empty() ? 0 : qualified_name(found.dli_sname, name, sizeof name);
    // A step's library also contains instances of other libraries' templates: skip them.
    if (!std::string_view(name, length).starts_with("atelier::")) continue;
    Line line;
    for (const std::string_view piece : {std::string_view("error: in "), std::string_view(name, length),
                                         std::string_view(" ("), step, std::string_view(")\n")})
      line.add(piece);
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, line.text.data(), line.size);
    break;
  }
  ::raise(number);  // delivered when this handler returns, with the default action
}

}  // namespace

std::size_t qualified_name(const char* mangled, char* name, std::size_t capacity) {
  // The Itanium C++ ABI: _ZN, then each part's length in decimal before its letters, then E.
  if (std::strncmp(mangled, "_ZN", 3) != 0) return 0;
  const char* at = mangled + 3;
  std::size_t size = 0;
  while (*at != 'E') {
    std::size_t length = 0;
    for (; *at >= '0' && *at <= '9' && length < capacity; ++at) length = 10 * length + std::size_t(*at - '0');
    if (length == 0 || ::strnlen(at, length) < length || size + 2 + length > capacity) return 0;
    if (size > 0) std::memcpy(name + size, "::", 2), size += 2;
    std::memcpy(name + size, at, length);
    size += length;
    at += length;
  }
  return size;
}

void name_function_on_crash() {
  if (sanitizer_reports) return;
  void* none[1];
  ::backtrace(none, 1);  // its first call loads a library, which a handler must not do
  static std::array<char, alternate_stack> stack_memory;
  const stack_t stack{.ss_sp = stack_memory.data(), .ss_flags = 0, .ss_size = stack_memory.size()};
  ::sigaltstack(&stack, nullptr);
  struct sigaction action {};
  action.sa_handler = report_function;
  action.sa_flags = int(SA_ONSTACK | SA_RESETHAND);
  for (const int number : crashes) ::sigaction(number, &action, nullptr);
}

}  // namespace atelier
