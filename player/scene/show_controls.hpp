#pragma once

#include <cstdint>
#include <set>
#include <string>

namespace vitrine::player {

/// The wishes of an operator for a show: a pause, turns, pins.
struct ShowControls {
    bool is_paused = false;       // no shot takes its turn, and films play on
    std::uint64_t turns = 0;      // number asked for so far; for each, one shot gives way at once
    std::set<std::string> files;  // pinned: brought onto the wall, where they stay
    std::set<int> slots;          // pinned: keep the shot that they have

    bool operator==(const ShowControls&) const = default;
};

}  // namespace vitrine::player
