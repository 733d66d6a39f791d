#pragma once

#include "player/scene/acts/wall_act.hpp"
#include "player/scene/wall.hpp"

#include <chrono>
#include <map>
#include <optional>

namespace vitrine::player {

/// The act of a wall as it is now, without a name and the parts of outputs.
WallAct act_of(const WallParts& parts, const TransitionStyle& style);

/// Tells what hands do above a wall. @param now  of the wall
LiftedMoment lifted_moment(const WallParts& parts, std::chrono::nanoseconds now);

/// The files in the store from which a wall and the change under way play.
std::map<SourceId, std::optional<StoredShot>> stored_files(const WallParts& parts);

}  // namespace vitrine::player
