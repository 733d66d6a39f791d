#pragma once

#include "player/scene/lifted_shots.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace vitrine::player {

/// What hands hold above the wall, for the boxes that follow. @param run  of the leader, whose sources it
/// names
std::string lifted_to_json(std::int64_t run, const LiftedMoment& seen);

/// @return the run of the leader, and what it has drawn
/// @throws std::runtime_error with one sentence
std::pair<std::int64_t, LiftedMoment> lifted_from_json(std::string_view text);

}  // namespace vitrine::player
