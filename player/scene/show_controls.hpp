#pragma once

#include <cstdint>
#include <set>
#include <string>

namespace vitrine::player {

/// What somebody wants of a show, beside its files.
struct ShowControls {
    bool is_paused = false;       // no shot takes its turn; films play on
    std::uint64_t turns = 0;      // asked for so far: for each, one shot gives way at once
    std::set<std::string> files;  // pinned: brought onto the wall, where they stay
    std::set<int> slots;          // pinned: keep the shot that they have

    bool operator==(const ShowControls&) const = default;
};

}  // namespace vitrine::player
