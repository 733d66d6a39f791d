#include "player/content/crash_signal.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstddef>
#include <system_error>

namespace vitrine::player {

namespace {

constexpr std::array crash_signals{SIGSEGV, SIGABRT, SIGBUS, SIGILL, SIGFPE, SIGTRAP, SIGSYS};

int crash_file = -1;  // open for as long as the process lives

/// Runs in a process that is beyond help: only calls that are safe in a signal handler. The kernel gives a
/// fault of the process itself a positive code; abort() and raise() name the process as the sender.
void write_signal(int signal, siginfo_t* info, void* /*context*/) {
    const bool is_own = info->si_code > 0 || (info->si_code == SI_TKILL && info->si_pid == ::getpid());
    const std::array<char, 3> text{static_cast<char>('0' + signal / 10), static_cast<char>('0' + signal % 10),
                                   '\n'};
    if (is_own && ::write(crash_file, text.data(), text.size()) < 0) ::_exit(128 + signal);
    ::signal(signal, SIG_DFL);
    ::raise(signal);  // comes as soon as this function has returned
}

/// Gives the handler a stack of its own in this thread, as a stack that is used up has no room for it.
void use_own_stack() {
    constexpr std::size_t size = 64UL << 10U;
    stack_t stack{};
    if (::sigaltstack(nullptr, &stack) < 0 || (stack.ss_flags & SS_DISABLE) == 0) return;
    void* room = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (room == MAP_FAILED) return;
    stack = {.ss_sp = room, .ss_flags = 0, .ss_size = size};
    ::sigaltstack(&stack, nullptr);
}

}  // namespace

void note_own_crash(const std::filesystem::path& file) {
    const int opened = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (crash_file >= 0) ::close(crash_file);
    crash_file = opened;
    if (crash_file < 0) return;
    use_own_stack();

    struct sigaction action {};

    action.sa_sigaction = write_signal;
    action.sa_flags = SA_SIGINFO | SA_ONSTACK;
    for (const int signal : crash_signals)
        ::sigaction(signal, &action, nullptr);
}

bool has_own_crash(const std::filesystem::path& file) {
    std::error_code none;
    const auto size = std::filesystem::file_size(file, none);
    return !none && size > 0;
}

}  // namespace vitrine::player
