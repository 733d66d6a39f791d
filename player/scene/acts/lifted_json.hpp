#pragma once

#include "player/scene/lifted_shots.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace vitrine::player {

/// Writes down what hands hold above the wall, for the boxes that follow.
/// @param run  of the leader; its sources have numbers of their own in each run
std::string lifted_to_json(std::int64_t run, const LiftedMoment& seen);

/// Reads what the leader has written. @return the leader's run, and what hands hold there
/// @throws std::runtime_error with one sentence
std::pair<std::int64_t, LiftedMoment> lifted_from_json(std::string_view text);

}  // namespace vitrine::player
