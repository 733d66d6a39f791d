#pragma once

#include "player/layout/plan/plan_request.hpp"

#include <vector>

namespace vitrine::player {

/// The requests in which a newcomer takes the place of an item that stays, and that item the newcomer's seat.
/// A small picture fits better there than into the seat of a large one. At most four, those with the shortest
/// way first.
std::vector<PlanRequest> seat_exchanges(const PlanRequest& request);

}  // namespace vitrine::player
