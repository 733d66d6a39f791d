#include "player/layout/plan_request.hpp"

#include "player/layout/shape.hpp"

namespace vitrine {

Seat seat_of(const LayoutItem& item, const Placement& placement) {
    const Shape shape = shape_of(item.region);
    return {shape.centroid * placement.scale + placement.offset,
            shape.area * placement.scale * placement.scale};
}

}  // namespace vitrine
