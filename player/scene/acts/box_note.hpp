#pragma once

#include "player/scene/acts/wall_act.hpp"

#include <chrono>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine::player {

/// An output of a box as it tells the others.
struct BoxOutput {
    std::string name;
    int width = 0;  // px, as the panel has them
    int height = 0;
    int turned = 0;  // degrees clockwise by which it hangs turned: 0, 90, 180 or 270

    bool operator==(const BoxOutput&) const = default;
};

/// The facts that a box of a wall tells the others of itself.
struct BoxNote {
    bool leads = false;
    bool is_gone = false;     // vitrine-link says so: the box has not said goodbye
    bool has_guides = false;  // it draws guides for placing screens; if it leads, all boxes do
    bool is_awake = false;    // a touch lights its panels for a while, and those of all boxes
    std::vector<BoxOutput> outputs = {};
    std::optional<ActName> shown = {};        // the act that it draws; none: none yet
    std::vector<std::string> lacking = {};    // paths of shots that it has not got; at most 100
    std::string fetch_fault = {};             // why it could not fetch files the last time; empty: it could
    bool has_right_clock = false;             // its system's clock is kept right
    std::chrono::microseconds difference{0};  // of its shared time from that clock

    bool operator==(const BoxNote&) const = default;
};

constexpr std::size_t max_told_lacks = 100;

std::string to_json(const BoxNote& note);

/// @throws std::runtime_error with one sentence
BoxNote box_note_from_json(std::string_view text);

/// The answer of a box to a preparation: it has all its shots.
std::string ready_to_json(const ActName& preparation);

/// @throws std::runtime_error with one sentence
ActName ready_from_json(std::string_view text);

}  // namespace vitrine::player
