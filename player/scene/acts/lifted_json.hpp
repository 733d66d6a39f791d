#pragma once

#include "player/scene/lifted_shots.hpp"
#include "player/scene/tapestry/tapestry_moment.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace vitrine::player {

/// The leader tells by this what hands do above its wall.
struct ToldHands {
    std::int64_t run = 0;  // of the leader; its sources have numbers of their own in each run
    LiftedMoment lifted = {};
    std::optional<TapestryMoment> tapestry = {};  // in place of the wall, in shared time

    bool is_nothing() const { return lifted.is_nothing() && !tapestry; }

    bool operator==(const ToldHands&) const = default;
};

/// Writes down what hands do, for the boxes that follow.
std::string lifted_to_json(const ToldHands& told);

/// Reads what the leader has written. @throws std::runtime_error with one sentence
ToldHands lifted_from_json(std::string_view text);

}  // namespace vitrine::player
