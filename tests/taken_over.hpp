#pragma once

#include <fcntl.h>
#include <netinet/in.h>
#include <sched.h>
#include <sys/inotify.h>
#include <sys/ioctl.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

// A hostile file has taken a reader over, and tries these things. None of them harms a process that is in no
// sandbox, nor its parent.

namespace vitrine::taken_over {

/// One thing to reach.
struct Try {
    std::string name;
    std::function<bool()> reaches;
};

/// The things that a taken-over reader tries to reach.
struct Prey {
    std::filesystem::path media;   // the file that the process reads
    std::filesystem::path record;  // another file of the same user
    std::filesystem::path folder;  // that the process writes; empty: none
    std::string socket;            // a socket that listens
    int descriptor = -1;           // of the file that the process reads; -1: none
    int unconnected = -1;          // a socket that was made before; -1: none
};

/// True where a call did not fail.
inline bool is_done(long result) {
    return result >= 0;
}

/// True where a call with wrong arguments was let through: it failed, but for another reason than that it is
/// forbidden.
inline bool is_let_through(long result, int refusal = EPERM) {
    return is_done(result) || errno != refusal;
}

inline bool is_opened(const std::filesystem::path& file, int flags) {
    constexpr mode_t mode = 0644;
    const int fd = ::open(file.c_str(), flags | O_CLOEXEC, mode);
    if (fd >= 0) ::close(fd);
    return fd >= 0;
}

inline bool is_connected(int socket, const std::string& name) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, name.c_str(), sizeof address.sun_path - 1);
    return is_done(::connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address));  // NOLINT
}

inline bool reads_parent() {
    static char byte = 0;
    const iovec here{&byte, 1};
    return is_let_through(::process_vm_readv(::getppid(), &here, 1, &here, 1, 0));
}

inline bool forks() {
    const pid_t made = ::fork();
    if (made == 0) ::_exit(0);
    return is_done(made);
}

/// Landlock forbids each of these.
inline std::vector<Try> file_tries(const Prey& prey) {
    const std::filesystem::path beside = prey.record.parent_path();
    const std::string again = "/proc/self/fd/" + std::to_string(prey.descriptor);
    return {
        {"a file of the system", [] { return is_opened("/etc/passwd", O_RDONLY); }},
        {"a folder of the system", [] { return is_opened("/etc", O_RDONLY | O_DIRECTORY); }},
        {"a record", [=] { return is_opened(prey.record, O_RDONLY); }},
        {"a record to write", [=] { return is_opened(prey.record, O_WRONLY); }},
        {"a record to empty", [=] { return is_opened(prey.record, O_WRONLY | O_TRUNC); }},
        {"its file to write", [=] { return is_opened(prey.media, O_WRONLY); }},
        {"its descriptor to write", [=] { return is_opened(again, O_RDWR); }},
        {"the folder of its file", [=] { return is_opened(prey.media.parent_path(), O_RDONLY); }},
        {"a file beside", [=] { return is_opened(beside / "beside", O_WRONLY | O_CREAT); }},
        {"a file above", [=] { return is_opened(prey.folder / "../beside", O_WRONLY | O_CREAT); }},
        {"through a link", [=] { return is_opened(prey.folder / "link", O_RDONLY); }},
        {"a record moved",
         [=] { return is_done(::rename(prey.record.c_str(), (prey.folder / "moved").c_str())); }},
        {"a record removed", [=] { return is_done(::unlink(prey.record.c_str())); }},
        {"a folder beside", [=] { return is_done(::mkdir((beside / "made").c_str(), S_IRWXU)); }},
        {"memory by its file",
         [] { return is_opened("/proc/" + std::to_string(::getppid()) + "/mem", O_RDONLY); }},
        {"its own memory map", [] { return is_opened("/proc/self/maps", O_RDONLY); }},
        {"a program's file", [] { return is_opened("/proc/self/exe", O_RDONLY); }},
    };
}

/// Seccomp forbids each of these, whatever Landlock the kernel has. The last replaces the process where it is
/// reached.
inline std::vector<Try> call_tries(const Prey& prey) {
    const pid_t parent = ::getppid();
    return {
        {"a record cut short", [=] { return is_done(::truncate(prey.record.c_str(), 0)); }},
        {"a record's mode", [=] { return is_done(::chmod(prey.record.c_str(), S_IRWXU)); }},
        {"a record's time", [=] { return is_done(::utimensat(AT_FDCWD, prey.record.c_str(), nullptr, 0)); }},
        {"a hard link", [=] { return is_done(::link(prey.record.c_str(), (prey.folder / "hard").c_str())); }},
        {"a link", [=] { return is_done(::symlink("/etc/passwd", (prey.folder / "soft").c_str())); }},
        {"a pipe with a name", [=] { return is_done(::mkfifo((prey.folder / "fifo").c_str(), S_IRWXU)); }},
        {"news of a folder", [] { return is_done(::inotify_init1(IN_CLOEXEC)); }},
        {"a local socket", [] { return is_done(::socket(AF_UNIX, SOCK_STREAM, 0)); }},
        {"a network socket", [] { return is_done(::socket(AF_INET, SOCK_STREAM, 0)); }},
        {"a pair of datagram sockets",
         [] {
             std::array<int, 2> pair{};
             return is_done(::socketpair(AF_UNIX, SOCK_DGRAM, 0, pair.data()));
         }},
        {"a connection",
         [=] {
             const int made = ::socket(AF_UNIX, SOCK_STREAM, 0);
             return is_connected(made >= 0 ? made : prey.unconnected, prey.socket);
         }},
        {"a signal to its parent", [=] { return is_done(::kill(parent, 0)); }},
        {"a signal to all", [] { return is_done(::kill(-1, 0)); }},
        {"a signal to its group", [] { return is_done(::kill(0, 0)); }},
        {"a signal to a thread", [=] { return is_done(::syscall(SYS_tgkill, parent, parent, 0)); }},
        {"a queued signal", [=] { return is_done(::sigqueue(parent, 0, {})); }},
        {"signals by a descriptor", [=] { return is_done(::fcntl(STDERR_FILENO, F_SETOWN, parent)); }},
        {"a handle on its parent", [=] { return is_done(::syscall(SYS_pidfd_open, parent, 0)); }},
        {"a trace", [=] { return is_done(::ptrace(PTRACE_SEIZE, parent, nullptr, nullptr)); }},
        {"memory of its parent", reads_parent},
        {"limits of its parent",
         [=] {
             rlimit limit{};
             return is_done(::prlimit(parent, RLIMIT_NOFILE, nullptr, &limit));
         }},
        {"its parent's priority",
         [=] {
             const auto process = static_cast<id_t>(parent);
             return is_done(::setpriority(PRIO_PROCESS, process, ::getpriority(PRIO_PROCESS, process)));
         }},
        {"a namespace", [] { return is_let_through(::unshare(CLONE_NEWUSER)); }},
        {"a mount", [] { return is_let_through(::mount("none", "/none/such", "tmpfs", 0, nullptr)); }},
        {"another root", [] { return is_let_through(::chroot("/none/such")); }},
        {"the kernel's rings",
         [] { return is_let_through(::syscall(SYS_io_uring_setup, 1, nullptr), ENOSYS); }},
        {"keys", [] { return is_done(::syscall(SYS_keyctl, 0, -3, 0)); }},
        {"faults in memory", [] { return is_done(::syscall(SYS_userfaultfd, O_CLOEXEC | 1)); }},
        {"a key for the terminal",
         [] { return is_let_through(::ioctl(STDERR_FILENO, FIOASYNC, nullptr), ENOTTY); }},
        {"a process", forks},
        {"a process by new ways", [] { return is_let_through(::syscall(SYS_clone3, nullptr, 0), ENOSYS); }},
        {"a program", [] { return is_done(::execl("/bin/true", "true", nullptr)); }},
    };
}

}  // namespace vitrine::taken_over
