#include "player/layout/plan/plan_request.hpp"

#include "player/layout/pack/shape.hpp"

namespace vitrine::player {

bool has_pinned_place(const PlanItem& item) {
    return item.is_pinned && item.previous;
}

Seat seat_of(const LayoutItem& item, const Placement& placement) {
    const Shape shape = shape_of(item.region);
    return {shape.centroid * placement.scale + placement.offset,
            shape.area * placement.scale * placement.scale};
}

}  // namespace vitrine::player
