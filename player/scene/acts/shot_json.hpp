#pragma once

#include "player/scene/acts/act_fields.hpp"
#include "player/scene/wall_shot.hpp"

#include <string>
#include <vector>

namespace vitrine::player {

/// A shot of an act with all that is needed to play and to draw it. Its file is the one in the store; a
/// shot that has none there yet is named by its path alone, and no follower can show it.
ActJson shot_to_json(const WallShot& shot);

/// @throws ActFault, nlohmann::json::exception
WallShot shot_from_json(const ActJson& json);

/// A shot at its place. @param shot  the number of its shot in the act
ActJson placed_to_json(const PlacedShot& placed, std::size_t shot);

/// @param shots    those of the act
/// @param canvas   px
/// @throws ActFault, nlohmann::json::exception; also where the cells could not be made for such a place
PlacedShot placed_from_json(const ActJson& json, const std::vector<WallShot>& shots, Vec2 canvas);

}  // namespace vitrine::player
