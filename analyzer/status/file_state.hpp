#pragma once

#include <chrono>
#include <cstddef>
#include <map>
#include <string>

namespace vitrine::analyzer {

/// The state of one file of the media folder, for those who ask why it is not on the wall.
struct FileState {
    enum class State {
        ready,        // may be shown; of a film, perhaps only its first shots so far
        copying,      // it changed within the quiet time
        analysing,    // whole as far as can be told: being analysed, or soon
        waiting,      // incomplete: tried again later
        unsupported,  // whole, but nothing that can be shown
        failed,       // looked like a medium and could not be read
        quarantined,  // crashed or hung a reader or the player twice; tried again only when it changes
    };

    std::string path;  // relative to the media folder, any bytes
    State state = State::copying;
    std::chrono::system_clock::time_point
        since;           // ready and below: when that was found out (after a restart:
                         // the start); else when this content was first seen
    std::string reason;  // plain words; empty where there is nothing to say

    bool operator==(const FileState&) const = default;
};

/// Files in each state; a state without files may be missing.
using StateCounts = std::map<FileState::State, std::size_t>;

constexpr const char* name_of(FileState::State state) {
    switch (state) {
    case FileState::State::ready:
        return "ready";
    case FileState::State::copying:
        return "copying";
    case FileState::State::analysing:
        return "analysing";
    case FileState::State::waiting:
        return "waiting";
    case FileState::State::unsupported:
        return "unsupported";
    case FileState::State::failed:
        return "failed";
    case FileState::State::quarantined:
        return "quarantined";
    }
    return "";
}

}  // namespace vitrine::analyzer
