#pragma once

#include "player/layout/cells/cells.hpp"
#include "player/scene/acts/act_fields.hpp"

namespace vitrine::player {

/// A cell with all that is drawn of it. Its corners stand in one list, in steps of the cells' grid, which are
/// whole numbers as long as the wall was not scaled; outlines and triangles name them by their numbers.
ActJson cell_to_json(const Cell& cell);

/// The same cell again, bit by bit. @throws ActFault, nlohmann::json::exception
Cell cell_from_json(const ActJson& json);

}  // namespace vitrine::player
