#include "player/layout/plan/seat_exchanges.hpp"

#include "player/layout/pack/shape.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace vitrine::player {

namespace {

/// The placement of an item on the seat of another one.
Placement placed_on(const Seat& seat, const LayoutItem& item, double max_scale) {
    const Shape shape = shape_of(item.region);
    const double scale = std::min(std::sqrt(seat.area / shape.area), max_scale);
    return {scale, seat.centre - shape.centroid * scale};
}

}  // namespace

std::vector<PlanRequest> seat_exchanges(const PlanRequest& request) {
    constexpr std::size_t max_exchanges = 4;
    std::vector<std::pair<double, PlanRequest>> found;  // with the distance of both places
    for (std::size_t i = 0; i < request.items.size(); ++i) {
        const PlanItem& newcomer = request.items[i];
        if (newcomer.previous || !newcomer.seat || newcomer.seat->area <= 0) continue;
        for (std::size_t k = 0; k < request.items.size(); ++k) {
            const PlanItem& kept = request.items[k];
            if (!kept.previous || kept.is_pinned || kept.is_band) continue;
            const Seat seat = seat_of(kept.item, *kept.previous);
            PlanRequest exchanged = request;
            exchanged.items[i].seat = seat;
            exchanged.items[k].previous = placed_on(*newcomer.seat, kept.item, request.max_scale);
            exchanged.items[k].home.reset();
            found.emplace_back(length(seat.centre - newcomer.seat->centre), std::move(exchanged));
        }
    }
    std::ranges::sort(found, {}, &std::pair<double, PlanRequest>::first);
    found.resize(std::min(found.size(), max_exchanges));
    std::vector<PlanRequest> nearest;
    nearest.reserve(found.size());
    for (auto& [distance, exchanged] : found)
        nearest.push_back(std::move(exchanged));
    return nearest;
}

}  // namespace vitrine::player
