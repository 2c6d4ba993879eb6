// Runs strangers' code: a compiler on their sources, and the program with their code in it.
//
// A confined program sees the system's programs and libraries in /usr, what its Room lists, and nothing else: no home
// folder, no references, no other submission, no network, no process but its own, no environment but what it is given.
// It runs under an account of its own where the grader is root, without new privileges, behind a filter of system calls
// (confine/system_calls.hpp), and within limits. What it starts ends with it.
//
// Two programs do this: bubblewrap makes the namespaces, and atelier-confine (confine/) does all else, in this order:
//
//   atelier-confine --cgroup ... -- bwrap MOUNTS -- atelier-confine --account ... -- PROGRAM
#pragma once

#include <sys/types.h>

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/descriptor.hpp"
#include "base/file.hpp"
#include "base/launch.hpp"
#include "sandbox/control_group.hpp"
#include "sandbox/tier.hpp"

namespace atelier::sandbox {

struct Limits {
  std::size_t memory = std::size_t(4) << 30;     ///< bytes of address space of a process; all together, in a cgroup
  std::size_t file = std::size_t(300) << 20;     ///< bytes of one file
  std::size_t scratch = std::size_t(256) << 20;  ///< bytes of /tmp
  int processes = 64;                            ///< with threads
  int processor_seconds = 1200;                  ///< of one process
};

/// What a program may use besides /usr.
struct Room {
  std::vector<std::filesystem::path> readable;  ///< files and folders; what does not exist is left out
  std::vector<std::filesystem::path> writable;  ///< existing folders
  /// An empty folder of limited size. Where there are namespaces it exists only inside, and is received
  /// (Confined::receive_answers); otherwise it is the folder of this path.
  std::filesystem::path answers;
  std::size_t answers_bytes = std::size_t(64) << 20;
  Limits limits;
};

/// A command that starts a program confined. Keep it until the program has ended.
struct Confined {
  Launch launch;
  Descriptor ours, theirs;  ///< ends of the socket on which atelier-confine reports; none in the tier none
  bool sends_answers = false;
  int reports = 0;  ///< received: one if the program was started, none or two if it was not

  /// Waits until the program starts, and returns the folder of answers; none if it has none of its own. False if the
  /// program was not started within 10 s.
  bool receive_answers(Descriptor& answers);

  /// Once it has ended: whether the program itself was started. What it prints cannot change that.
  bool was_started();
};

/// One submission's sandbox. Its programs share an account and a control group, and no other sandbox has them.
class Sandbox {
 public:
  /// Throws Error if no account is free.
  explicit Sandbox(Tier tier, const Limits& limits = {});
  ~Sandbox();  ///< kills what still runs in it
  Sandbox(const Sandbox&) = delete;
  Sandbox& operator=(const Sandbox&) = delete;

  Tier tier() const { return tier_; }
  bool has_control_group() const { return group_ != nullptr; }

  /// `wanted` inside of `room`. Its environment is all that it gets; HOME and TMPDIR are the sandbox's own.
  Confined confine(const Launch& wanted, const Room& room) const;

  /// Lets confined programs go through this folder to what they may use.
  void let_through(const std::filesystem::path& folder) const;

  /// Lets confined programs write into this folder, and go through the folder around it.
  void give(const std::filesystem::path& folder) const;

  /// To be called when a confined program has ended. Once none of this sandbox runs, kills what they have left behind
  /// and waits until it is gone.
  void program_ended() const;

  /// Whether none of its programs runs: if one was not started then, it is not for what another one does.
  bool is_idle() const { return running_ == 0; }

  /// How many processes the system has killed so far because all together needed more memory than limits().memory.
  int memory_kills() const;
  const Limits& limits() const { return limits_; }

 private:
  void take_account();
  bool sends_answers(const Room& room) const;
  std::vector<std::string> inner_arguments(const Room& room) const;
  std::vector<std::string> outer_arguments(const Launch& wanted, const Room& room) const;
  void kill_all() const;
  void kill_account() const;

  Tier tier_;
  Limits limits_;
  std::optional<uid_t> account_;  ///< none: that of the grader, which is not root
  Descriptor reservation_;        ///< of the account
  std::unique_ptr<ControlGroup> group_;
  std::optional<TemporaryFolder> scratch_;  ///< in place of /tmp, where there is no file system of its own
  mutable std::atomic<int> running_{0};
};

/// bubblewrap reports a signal as a shell does, as status 128 + number. Returns the signal, or 0.
int signal_of_status(int status);

/// "4 GiB", "512 MiB"
std::string in_words(std::size_t bytes);

/// Why a program was not started, from the output in its place.
std::string failure_of_sandbox(const std::string& output);

}  // namespace atelier::sandbox
