#pragma once

#include <chrono>
#include <string_view>

namespace vitrine {

/// Who is to blame when a file cannot be shown. Only a fault of the file is ever final.
enum class FaultOwner {
    file,       // its bytes are wrong, or no reader survives them
    transport,  // the way to its bytes: a disk, a share, a server, a cable
    machine,    // this machine: no memory, no descriptor, no process
    program,    // Vitrine: an answer that makes no sense
};

/// The owner of an error that a call on a media file gave: the machine where it lacks something, else the
/// transport. A call never fails for what stands inside the file.
/// @param error  errno
FaultOwner fault_owner(int error);

/// A name for records: "file", "transport", "machine" or "program".
constexpr std::string_view name_of(FaultOwner owner) {
    switch (owner) {
    case FaultOwner::file:
        return "file";
    case FaultOwner::transport:
        return "transport";
    case FaultOwner::machine:
        return "machine";
    case FaultOwner::program:
        break;
    }
    return "program";
}

/// A fault over time, as a record holds it. Times are those of the wall clock, in seconds since 1970.
struct Fault {
    FaultOwner owner = FaultOwner::file;
    std::chrono::seconds since{0};  // 0: there is none, or it is not known
    std::chrono::seconds until{0};  // the end of a quarantine
    int quarantines = 0;            // how often this content was quarantined

    bool operator==(const Fault&) const = default;
};

}  // namespace vitrine
