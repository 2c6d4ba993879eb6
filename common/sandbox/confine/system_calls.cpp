#include "system_calls.hpp"

#include <asm/ioctls.h>
#include <errno.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace atelier::confine {
namespace {

constexpr int refused[] = {
    // other processes
    SYS_ptrace,
    SYS_process_vm_readv,
    SYS_process_vm_writev,
    SYS_kcmp,
    SYS_pidfd_getfd,
    SYS_process_madvise,
    // network and messages
    SYS_socket,
    SYS_connect,
    SYS_bind,
    SYS_listen,
    SYS_accept,
    SYS_accept4,
    SYS_mq_open,
    SYS_shmget,
    SYS_semget,
    SYS_msgget,
    // mounts and namespaces
    SYS_mount,
    SYS_umount2,
    SYS_pivot_root,
    SYS_chroot,
    SYS_unshare,
    SYS_setns,
    SYS_open_tree,
    SYS_move_mount,
    SYS_fsopen,
    SYS_fsconfig,
    SYS_fsmount,
    SYS_fspick,
    SYS_name_to_handle_at,
    SYS_open_by_handle_at,
    // keys, kernel, tracing
    SYS_add_key,
    SYS_request_key,
    SYS_keyctl,
    SYS_bpf,
    SYS_perf_event_open,
    SYS_userfaultfd,
    SYS_io_uring_setup,
    SYS_io_uring_enter,
    SYS_io_uring_register,
    SYS_init_module,
    SYS_finit_module,
    SYS_delete_module,
    SYS_kexec_load,
    SYS_syslog,
    SYS_acct,
    SYS_swapon,
    SYS_swapoff,
    SYS_reboot,
    SYS_quotactl,
    SYS_settimeofday,
    SYS_clock_settime,
    SYS_adjtimex,
    SYS_clock_adjtime,
    SYS_sethostname,
    SYS_setdomainname,
    SYS_fanotify_init,
    SYS_lookup_dcookie,
    SYS_personality,
    SYS_vhangup,
    SYS_inotify_init1,  // which would tell when others use a file, even one that cannot be opened
    SYS_inotify_add_watch,
    SYS_mbind,
    SYS_migrate_pages,
    SYS_move_pages,
#if defined(SYS_kexec_file_load)
    SYS_kexec_file_load,
#endif
#if defined(SYS_mount_setattr)
    SYS_mount_setattr,
#endif
#if defined(SYS_iopl)
    SYS_iopl,
    SYS_ioperm,
    SYS_modify_ldt,
#endif
};

constexpr std::uint32_t new_namespaces =
    CLONE_NEWNS | CLONE_NEWCGROUP | CLONE_NEWUTS | CLONE_NEWIPC | CLONE_NEWUSER | CLONE_NEWPID | CLONE_NEWNET;

#if defined(__x86_64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_X86_64, foreign_calls = 0x40000000;  // x32
#elif defined(__aarch64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_AARCH64, foreign_calls = 0;
#else
constexpr std::uint32_t architecture = 0, foreign_calls = 0;
#endif

constexpr std::uint32_t refuse(int reason) {
  return SECCOMP_RET_ERRNO | std::uint32_t(reason);
}

/// The program of the Berkeley Packet Filter that the kernel runs at each call. Each test is followed by its answer, so
/// that no jump is longer than one instruction.
class Filter {
 public:
  void load(std::size_t offset) { add(BPF_LD | BPF_W | BPF_ABS, std::uint32_t(offset)); }
  void answer(std::uint32_t value) { add(BPF_RET | BPF_K, value); }
  void answer_if_equal(std::uint32_t value, std::uint32_t then) { test(BPF_JEQ, value, then); }
  void answer_unless_equal(std::uint32_t value, std::uint32_t then) {
    code_.push_back({BPF_JMP | BPF_JEQ | BPF_K, 1, 0, value});
    answer(then);
  }
  void answer_if_any_bit(std::uint32_t bits, std::uint32_t then) { test(BPF_JSET, bits, then); }
  void answer_if_at_least(std::uint32_t value, std::uint32_t then) { test(BPF_JGE, value, then); }
  /// For this call, the four bytes of an argument decide; then its number is loaded again.
  template <class Test>
  void for_call(int call, std::size_t argument, Test test) {
    code_.push_back({BPF_JMP | BPF_JEQ | BPF_K, 0, 0, std::uint32_t(call)});
    const std::size_t jump = code_.size() - 1;
    load(offsetof(seccomp_data, args) + 8 * argument);
    test();
    load(offsetof(seccomp_data, nr));
    code_[jump].jf = std::uint8_t(code_.size() - jump - 1);
  }

  sock_fprog program() { return {.len = static_cast<unsigned short>(code_.size()), .filter = code_.data()}; }

 private:
  void add(int code, std::uint32_t value) { code_.push_back({std::uint16_t(code), 0, 0, value}); }
  void test(int jump, std::uint32_t value, std::uint32_t then) {
    code_.push_back({std::uint16_t(BPF_JMP | jump | BPF_K), 0, 1, value});
    answer(then);
  }
  std::vector<sock_filter> code_;
};

}  // namespace

bool refuse_system_calls() {
  if (architecture == 0) {
    errno = ENOSYS;
    return false;
  }
  Filter filter;
  filter.load(offsetof(seccomp_data, arch));
  filter.answer_unless_equal(architecture, SECCOMP_RET_KILL_PROCESS);
  filter.load(offsetof(seccomp_data, nr));
  if (foreign_calls) filter.answer_if_at_least(foreign_calls, refuse(ENOSYS));
  for (const int call : refused) filter.answer_if_equal(std::uint32_t(call), refuse(EPERM));
  // The flags of clone3 lie in memory, where a filter cannot look; the C library then uses clone.
  filter.answer_if_equal(SYS_clone3, refuse(ENOSYS));
  filter.for_call(SYS_clone, 0, [&] { filter.answer_if_any_bit(new_namespaces, refuse(EPERM)); });
  filter.for_call(SYS_ioctl, 1, [&] {
    filter.answer_if_equal(TIOCSTI, refuse(EPERM));  // types into a terminal
    filter.answer_if_equal(TIOCLINUX, refuse(EPERM));
  });
  filter.answer(SECCOMP_RET_ALLOW);
  const sock_fprog program = filter.program();
  return ::syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, 0, &program) == 0;
}

}  // namespace atelier::confine
