// Landlock decides which files can be opened or changed, seccomp which calls can be made. Landlock of
// Linux 6.1 knows neither sockets nor signals, and neither truncate() by name nor the change of modes and
// times, so the calls are limited too. The filter lists what is allowed: what a later kernel brings is
// refused.

#include "base/system/sandbox.hpp"

#include "base/system/error.hpp"
#include "base/system/unique_fd.hpp"

#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/landlock.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <system_error>

#if defined(__SANITIZE_ADDRESS__)
#include <sanitizer/lsan_interface.h>
#endif

#if defined(__SANITIZE_ADDRESS__)
namespace {
bool is_sandboxed = false;
}

// LeakSanitizer looks for leaks from a process that traces this one, which the sandbox forbids.
int __lsan_is_turned_off() {  // NOLINT(bugprone-reserved-identifier)
    return is_sandboxed ? 1 : 0;
}
#endif

namespace vitrine {

namespace {

// Landlock. The headers of Debian 12 know what Linux 6.1 has (ABI 2); later kernels have more.

struct Ruleset {  // as the kernel reads it
    std::uint64_t files = 0;
    std::uint64_t network = 0;
    std::uint64_t scopes = 0;
};

constexpr int truncate_abi = 3;
constexpr int network_abi = 4;
constexpr int device_abi = 5;
constexpr int scope_abi = 6;

constexpr std::uint64_t read_right = LANDLOCK_ACCESS_FS_READ_FILE;
constexpr std::uint64_t truncate_right = 1U << 14U;
constexpr std::uint64_t device_right = 1U << 15U;
constexpr std::uint64_t bind_and_connect = 3;  // TCP
constexpr std::uint64_t sockets_and_signals = 3;
constexpr std::uint64_t first_rights = (LANDLOCK_ACCESS_FS_MAKE_SYM << 1U) - 1;  // all of ABI 1
constexpr std::uint64_t folder_rights = read_right | LANDLOCK_ACCESS_FS_WRITE_FILE |
                                        LANDLOCK_ACCESS_FS_READ_DIR | LANDLOCK_ACCESS_FS_REMOVE_DIR |
                                        LANDLOCK_ACCESS_FS_REMOVE_FILE | LANDLOCK_ACCESS_FS_MAKE_DIR |
                                        LANDLOCK_ACCESS_FS_MAKE_REG | truncate_right;

/// 0: the kernel has no Landlock, or this process may not use it.
int landlock_abi() {
    const long abi =
        ::syscall(SYS_landlock_create_ruleset, nullptr, std::size_t{0}, LANDLOCK_CREATE_RULESET_VERSION);
    return abi > 0 ? static_cast<int>(abi) : 0;
}

/// All that a kernel can forbid.
Ruleset all_rights(int abi) {
    Ruleset rights{.files = first_rights};
    if (abi > 1) rights.files |= LANDLOCK_ACCESS_FS_REFER;
    if (abi >= truncate_abi) rights.files |= truncate_right;
    if (abi >= device_abi) rights.files |= device_right;
    if (abi >= network_abi) rights.network = bind_and_connect;
    if (abi >= scope_abi) rights.scopes = sockets_and_signals;
    return rights;
}

void allow_below(const UniqueFd& ruleset, int file, std::uint64_t rights) {
    const landlock_path_beneath_attr rule{.allowed_access = rights, .parent_fd = file};
    if (::syscall(SYS_landlock_add_rule, ruleset.get(), LANDLOCK_RULE_PATH_BENEATH, &rule, 0) == 0) return;
    if (errno == EBADFD) return;  // a file in memory: Landlock lets it be opened again anyway
    throw_errno("add a file to the sandbox");
}

bool is_folder(int file) {
    struct stat status {};

    return ::fstat(file, &status) == 0 && S_ISDIR(status.st_mode);
}

void limit_files(const SandboxRules& rules, int abi) {
    const Ruleset rights = all_rights(abi);
    const std::size_t bytes = abi >= scope_abi     ? sizeof rights
                              : abi >= network_abi ? offsetof(Ruleset, scopes)
                                                   : offsetof(Ruleset, network);
    const UniqueFd ruleset(
        static_cast<int>(::syscall(SYS_landlock_create_ruleset, &rights, bytes, std::uint32_t{0})));
    if (!ruleset.is_open()) throw_errno("make a sandbox for files");
    for (const int file : rules.readable)
        allow_below(ruleset, file, is_folder(file) ? read_right | LANDLOCK_ACCESS_FS_READ_DIR : read_right);
    for (const int folder : rules.writable)
        allow_below(ruleset, folder, folder_rights & rights.files);
    if (::syscall(SYS_landlock_restrict_self, ruleset.get(), 0) != 0)
        throw_errno("enter the sandbox for files");
}

// seccomp.

#if defined(__x86_64__)
constexpr std::uint32_t machine = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t machine = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t machine = 0;  // its calls are not known here
#endif

// The calls that need no look at their arguments. Those that open and change files are Landlock's.
constexpr std::array free_calls {
    // memory
    SYS_brk, SYS_madvise, SYS_mincore, SYS_mlock, SYS_mmap, SYS_mprotect, SYS_mremap, SYS_msync, SYS_munlock,
        SYS_munmap, SYS_memfd_create, SYS_membarrier,
        // threads and the process itself
        SYS_exit, SYS_exit_group, SYS_futex, SYS_futex_waitv, SYS_getcpu, SYS_getegid, SYS_geteuid,
        SYS_getgid, SYS_getgroups, SYS_getpgid, SYS_getpid, SYS_getppid, SYS_getpriority, SYS_getresgid,
        SYS_getresuid, SYS_getrusage, SYS_getsid, SYS_gettid, SYS_getuid, SYS_restart_syscall, SYS_rseq,
        SYS_rt_sigaction, SYS_rt_sigpending, SYS_rt_sigprocmask, SYS_rt_sigreturn, SYS_rt_sigsuspend,
        SYS_rt_sigtimedwait, SYS_sched_get_priority_max, SYS_sched_get_priority_min, SYS_sched_getaffinity,
        SYS_sched_getattr, SYS_sched_getparam, SYS_sched_getscheduler, SYS_sched_yield, SYS_set_robust_list,
        SYS_set_tid_address, SYS_sigaltstack, SYS_sysinfo, SYS_times, SYS_umask, SYS_uname, SYS_wait4,
        SYS_waitid, SYS_getrandom,
        // clocks
        SYS_clock_getres, SYS_clock_gettime, SYS_clock_nanosleep, SYS_gettimeofday, SYS_nanosleep,
        SYS_getitimer, SYS_setitimer, SYS_timer_create, SYS_timer_delete, SYS_timer_getoverrun,
        SYS_timer_gettime, SYS_timer_settime, SYS_timerfd_create, SYS_timerfd_gettime, SYS_timerfd_settime,
        // descriptors
        SYS_close, SYS_close_range, SYS_copy_file_range, SYS_dup, SYS_dup3, SYS_epoll_create1, SYS_epoll_ctl,
        SYS_epoll_pwait, SYS_epoll_pwait2, SYS_eventfd2, SYS_fadvise64, SYS_fallocate, SYS_fdatasync,
        SYS_flock, SYS_fstat, SYS_fstatfs, SYS_fsync, SYS_ftruncate, SYS_getdents64, SYS_lseek, SYS_pipe2,
        SYS_ppoll, SYS_pread64, SYS_preadv, SYS_preadv2, SYS_pselect6, SYS_pwrite64, SYS_pwritev,
        SYS_pwritev2, SYS_read, SYS_readahead, SYS_readv, SYS_sendfile, SYS_signalfd4, SYS_splice,
        SYS_sync_file_range, SYS_tee, SYS_write, SYS_writev,
        // messages over sockets that are connected
        SYS_getpeername, SYS_getsockname, SYS_getsockopt, SYS_recvfrom, SYS_recvmsg, SYS_sendmsg,
        SYS_shutdown,
        // names
        SYS_faccessat, SYS_faccessat2, SYS_getcwd, SYS_mkdirat, SYS_newfstatat, SYS_openat, SYS_openat2,
        SYS_readlinkat, SYS_renameat2, SYS_statfs, SYS_statx, SYS_unlinkat,
#if defined(__x86_64__)  // older forms of the same
        SYS_access, SYS_alarm, SYS_creat, SYS_dup2, SYS_epoll_create, SYS_epoll_wait, SYS_eventfd,
        SYS_getdents, SYS_getpgrp, SYS_lstat, SYS_mkdir, SYS_open, SYS_pause, SYS_pipe, SYS_poll,
        SYS_readlink, SYS_rename, SYS_renameat, SYS_rmdir, SYS_select, SYS_signalfd, SYS_stat, SYS_time,
        SYS_unlink,
#else
        SYS_renameat,
#endif
};

// Calls that libraries try, and do without where the kernel does not have them. The flags of clone3 lie in
// memory, where no filter sees them.
constexpr std::array missing_calls{SYS_clone3, SYS_io_uring_setup, SYS_io_uring_enter, SYS_io_uring_register};

// Calls that do nothing and say that they did it: GLib sets the priority of each thread to what it is, and
// libraries set the mode of a file that they have just made. It keeps the mode that it was made with.
constexpr std::array idle_calls{SYS_sched_setattr, SYS_fchmod};

constexpr std::uint32_t first_unknown_call = 451;  // of Linux 6.2: libraries try new calls

constexpr std::uint32_t allow = SECCOMP_RET_ALLOW;

constexpr std::uint32_t refuse(int error) {
    return SECCOMP_RET_ERRNO | static_cast<std::uint32_t>(error);
}

/// A call that is allowed if one of its arguments has one of these values.
struct ArgumentRule {
    long call;
    std::size_t argument;  // 0: the first
    std::vector<std::uint32_t> allowed;
    std::uint32_t mask = ~0U;  // of the bits that are compared
    int error = EPERM;
};

/// A filter as the kernel runs it: it goes through the instructions until one answers.
class CallFilter {
  public:
    CallFilter() {
        load(offsetof(seccomp_data, arch));
        if_equal(machine, 1, 0);
        answer(refuse(ENOSYS));
        load(offsetof(seccomp_data, nr));
    }

    template <typename Calls> void add(const Calls& calls, std::uint32_t action) {
        for (const long call : calls) {
            if_equal(static_cast<std::uint32_t>(call), 0, 1);
            answer(action);
        }
    }

    void add(const ArgumentRule& rule) {
        constexpr std::size_t fixed = 3;  // load, mask, the last answer
        if_equal(static_cast<std::uint32_t>(rule.call), 0, fixed + 2 * rule.allowed.size());
        load(offsetof(seccomp_data, args) + rule.argument * sizeof(std::uint64_t));  // its low half
        add_step(BPF_ALU | BPF_AND | BPF_K, rule.mask);
        for (const std::uint32_t value : rule.allowed) {
            if_equal(value, 0, 1);
            answer(allow);
        }
        answer(refuse(rule.error));
    }

    /// Enters the filter, with the answers for all other calls.
    void enter() {
        add_step(BPF_JMP | BPF_JGE | BPF_K, first_unknown_call, 0, 1);  // those of x32 too
        answer(refuse(ENOSYS));
        answer(refuse(EPERM));
        const sock_fprog program{.len = static_cast<unsigned short>(steps_.size()), .filter = steps_.data()};
        const long result =
            ::syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_TSYNC, &program);
        if (result < 0) throw_errno("enter the sandbox for calls");
        if (result > 0) throw std::logic_error("a thread has another sandbox");
    }

  private:
    void load(std::size_t offset) { add_step(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(offset)); }

    void if_equal(std::uint32_t value, std::size_t steps_if, std::size_t steps_else) {
        add_step(BPF_JMP | BPF_JEQ | BPF_K, value, steps_if, steps_else);
    }

    void answer(std::uint32_t action) { add_step(BPF_RET | BPF_K, action); }

    void add_step(int code, std::uint32_t value, std::size_t steps_if = 0, std::size_t steps_else = 0) {
        steps_.push_back({.code = static_cast<std::uint16_t>(code),
                          .jt = static_cast<std::uint8_t>(steps_if),
                          .jf = static_cast<std::uint8_t>(steps_else),
                          .k = value});
    }

    std::vector<sock_filter> steps_;
};

/// Threads, but no processes.
ArgumentRule thread_rule() {
    constexpr std::uint32_t needed = CLONE_VM | CLONE_THREAD;
    constexpr std::uint32_t forbidden = CLONE_VFORK | CLONE_PTRACE | CLONE_NEWNS | CLONE_NEWCGROUP |
                                        CLONE_NEWUTS | CLONE_NEWIPC | CLONE_NEWUSER | CLONE_NEWPID |
                                        CLONE_NEWNET;
    return {.call = SYS_clone, .argument = 0, .allowed = {needed}, .mask = needed | forbidden};
}

/// Commands of fcntl, but for those by which the kernel sends signals to any process.
ArgumentRule descriptor_rule() {
    return {.call = SYS_fcntl,
            .argument = 1,
            .allowed = {F_GETFD, F_SETFD, F_GETFL, F_SETFL, F_DUPFD, F_DUPFD_CLOEXEC, F_GETLK, F_SETLK,
                        F_SETLKW, F_OFD_GETLK, F_OFD_SETLK, F_OFD_SETLKW, F_GETPIPE_SZ, F_SETPIPE_SZ,
                        F_ADD_SEALS, F_GET_SEALS}};
}

/// Pairs of sockets, by which GStreamer wakes its threads. Those of datagrams would reach other sockets.
ArgumentRule pair_rule() {
    return {.call = SYS_socketpair,
            .argument = 1,
            .allowed = {SOCK_STREAM, SOCK_SEQPACKET},
            .mask = ~static_cast<std::uint32_t>(SOCK_CLOEXEC | SOCK_NONBLOCK)};
}

void limit_calls() {
    const auto self = static_cast<std::uint32_t>(::getpid());
    CallFilter filter;
    filter.add(free_calls, allow);
    filter.add(thread_rule());
    filter.add(descriptor_rule());
    filter.add(pair_rule());
    filter.add({.call = SYS_kill, .argument = 0, .allowed = {self}});
    filter.add({.call = SYS_tgkill, .argument = 0, .allowed = {self}});
    filter.add({.call = SYS_prlimit64, .argument = 0, .allowed = {0, self}});
    filter.add({.call = SYS_prctl, .argument = 0, .allowed = {PR_SET_NAME, PR_GET_NAME}, .error = EINVAL});
    filter.add(std::array{SYS_ioctl}, refuse(ENOTTY));  // no device, and no key into a terminal
    filter.add(idle_calls, refuse(0));
    filter.add(missing_calls, refuse(ENOSYS));
    filter.enter();
}

bool has_call_filter() {
    std::uint32_t action = SECCOMP_RET_ERRNO;
    return machine != 0 && ::syscall(SYS_seccomp, SECCOMP_GET_ACTION_AVAIL, 0, &action) == 0;
}

/// Sanitizers may have a thread of their own, which is theirs alone.
void require_single_thread() {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    std::error_code unknown;
    const auto threads = std::distance(std::filesystem::directory_iterator("/proc/self/task", unknown), {});
    if (threads > 1) throw std::logic_error("a sandbox is entered before there are other threads");
#endif
}

}  // namespace

Sandbox available_sandbox() {
    return {.limits_files = landlock_abi() > 0, .limits_calls = has_call_filter()};
}

Sandbox enter_sandbox(const SandboxRules& rules) {
    const Sandbox sandbox = available_sandbox();
    require_single_thread();
    if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) throw_errno("give up new privileges");
    if (sandbox.limits_files) limit_files(rules, landlock_abi());
    if (sandbox.limits_calls) limit_calls();
#if defined(__SANITIZE_ADDRESS__)
    is_sandboxed = true;
#endif
    return sandbox;
}

std::string in_words(const Sandbox& sandbox) {
    const std::string calls = "no sockets, no signals, no programs";
    if (sandbox.limits_files && sandbox.limits_calls)
        return "readers are in a sandbox: no files but the one they read and the folders they write, " +
               calls;
    if (sandbox.limits_calls)
        return "readers are in half a sandbox, as this kernel has no Landlock: " + calls +
               ", but all files of this user";
    if (sandbox.limits_files)
        return "readers are in half a sandbox, as this kernel has no seccomp: no files but the one they read "
               "and the folders they write, but sockets, signals and programs";
    return "readers are in no sandbox, as this kernel has neither Landlock nor seccomp";
}

}  // namespace vitrine
