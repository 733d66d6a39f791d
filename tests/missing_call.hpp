#pragma once

#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace vitrine {

/// Runs a check in a process whose kernel lacks one call: the call fails with `error`.
/// @return what the check says; false where it throws
inline bool holds_without_call(long call, int error, const std::function<bool()>& check) {
    const pid_t child = ::fork();
    if (child == 0) {
        std::array steps{
            sock_filter{.code = BPF_LD | BPF_W | BPF_ABS, .jt = 0, .jf = 0, .k = offsetof(seccomp_data, nr)},
            sock_filter{
                .code = BPF_JMP | BPF_JEQ | BPF_K, .jt = 0, .jf = 1, .k = static_cast<std::uint32_t>(call)},
            sock_filter{.code = BPF_RET | BPF_K,
                        .jt = 0,
                        .jf = 0,
                        .k = SECCOMP_RET_ERRNO | static_cast<std::uint32_t>(error)},
            sock_filter{.code = BPF_RET | BPF_K, .jt = 0, .jf = 0, .k = SECCOMP_RET_ALLOW}};
        const sock_fprog program{.len = steps.size(), .filter = steps.data()};
        ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
        if (::syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, 0, &program) != 0) ::_exit(1);
        try {
            ::_exit(check() ? 0 : 1);
        } catch (...) {
            ::_exit(1);
        }
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace vitrine
