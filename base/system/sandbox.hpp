#pragma once

#include <string>
#include <vector>

namespace vitrine {

/// The files that a process may still reach in its sandbox, besides the descriptors that it holds. The
/// descriptors are needed for the call only.
struct SandboxRules {
    std::vector<int> readable;  // files that may be opened again to read, by name or as /proc/self/fd/N; of a
                                // folder all that is below it, and lists of it
    std::vector<int> writable;  // folders: below them files and folders may be read, made, renamed, removed
};

/// The parts of a sandbox that hold.
struct Sandbox {
    bool limits_files = false;  // Landlock: nothing but SandboxRules can be opened or changed
    bool limits_calls = false;  // seccomp: no socket, signal, program, process, trace, namespace, device call
};

/// The parts that this kernel has, and that this process may use.
Sandbox available_sandbox();

/// Gives up, for this process and for good, all that a reader of strangers' files does not need. What was
/// opened before stays open. Threads, memory, clocks, pipes and messages over connected sockets go on to
/// work; a forbidden call fails with an error, mostly EPERM or EACCES, and ends nothing. A part that the
/// kernel does not have is left out.
///
/// Load libraries, plugins and models before, and start no thread: the limits on files hold only for threads
/// that are started later. Hand over sockets of the kinds stream and seqpacket only: a datagram socket
/// reaches every address of its kind. A sandbox takes about a millisecond and cannot be entered twice.
///
/// @return  the parts that hold now
/// @throws std::system_error if a part that the kernel has cannot be entered; std::logic_error if other
/// threads run
Sandbox enter_sandbox(const SandboxRules& rules);

/// One sentence for the log, without a full stop: "readers are in a sandbox: ...".
std::string in_words(const Sandbox& sandbox);

}  // namespace vitrine
