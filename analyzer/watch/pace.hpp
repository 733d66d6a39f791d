#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace vitrine::analyzer {

/// The way in which a file was looked at: it decides how long the file must stay unchanged.
enum class LookKind {
    local,   // somebody may still be writing it
    closed,  // its writer has just closed or renamed it; some writers do so more than once
    remote,  // over a network
};

/// The waiting times of the schedule, and its limits.
struct Pace {
    std::size_t children = 1;               // files analysed at the same time, at least 1
    std::uint64_t small_bytes = 0;          // one more file up to this size is analysed beside them: a photo
    std::chrono::milliseconds quiet{2000};  // a file must stay unchanged for so long
    std::chrono::milliseconds closed_quiet{150};  // the same after its writer closed it, if that is shorter
    int remote_quiets = 3;  // quiet times on a network share: its server may answer from a cache for a while
    std::chrono::milliseconds rename_grace{500};  // a vanished file may turn up under another name
    std::chrono::milliseconds first_retry{
        5000};  // a waiting file is tried again; then after twice as long, ...
    std::chrono::milliseconds max_retry{3'600'000};  // no file waits longer for its next try
    int retries = 8;                                 // of a file that is not complete: together 21 minutes
    int deaths = 2;                                  // children that one content may kill before quarantine
    std::chrono::milliseconds death_memory{3'600'000};  // as long, a death of one file acquits the others

    /// @return how long a file must stay unchanged after such a look
    std::chrono::milliseconds quiet_after(LookKind look) const;

    /// @param tries  tries so far, at least 1
    /// @return the time until the next one
    std::chrono::milliseconds retry_after(int tries) const;
};

}  // namespace vitrine::analyzer
