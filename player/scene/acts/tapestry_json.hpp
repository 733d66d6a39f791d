#pragma once

#include "player/scene/acts/act_fields.hpp"
#include "player/scene/tapestry/tapestry_moment.hpp"

namespace vitrine::player {

/// A tapestry as the boxes of a wall tell each other of it. The same bits are read again.
ActJson tapestry_to_json(const TapestryMoment& seen);

/// @throws ActFault, nlohmann::json::exception  it is none, or one that cannot be drawn
TapestryMoment tapestry_from_json(const ActJson& json);

}  // namespace vitrine::player
