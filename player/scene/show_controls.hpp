#pragma once

#include "player/scene/arrangement.hpp"

#include <cstdint>
#include <memory>
#include <set>
#include <string>

namespace vitrine::player {

/// The wishes of an operator for a show: a pause, turns, pins; and of what covers it.
struct ShowControls {
    bool is_paused = false;       // no shot takes its turn; films continue
    bool is_held = false;         // no change begins at all, because something covers the wall
    std::uint64_t turns = 0;      // number of turns asked for so far; at each, one shot leaves at once
    std::set<std::string> files;  // pinned files: they come onto the wall and stay there
    std::set<int> slots;          // pinned slots: they keep their shots
    std::shared_ptr<const ArrangedWall> arranged;  // another one is taken once: the wall becomes so

    bool operator==(const ShowControls&) const = default;
};

}  // namespace vitrine::player
