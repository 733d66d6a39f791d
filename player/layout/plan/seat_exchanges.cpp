#include "player/layout/plan/seat_exchanges.hpp"

#include "player/layout/pack/shape.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace vitrine::player {

namespace {

/// The placement of an item on the seat of another one.
Placement placed_on(const Seat& seat, const LayoutItem& item, double max_scale) {
    const Shape shape = shape_of(item.region);
    const double scale = std::min(std::sqrt(seat.area / shape.area), max_scale);
    return {scale, seat.centre - shape.centroid * scale};
}

/// A newcomer and an item that stays, by their numbers.
struct Pair {
    std::size_t newcomer = 0;
    std::size_t kept = 0;
    double distance = 0;  // of their places, canvas px
};

std::vector<Pair> nearest_pairs(const PlanRequest& request) {
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < request.items.size(); ++i) {
        const PlanItem& newcomer = request.items[i];
        if (newcomer.previous || !newcomer.seat || newcomer.seat->area <= 0) continue;
        for (std::size_t k = 0; k < request.items.size(); ++k) {
            const PlanItem& kept = request.items[k];
            if (!kept.previous || kept.is_pinned || kept.is_band) continue;
            const Vec2 centre = seat_of(kept.item, *kept.previous).centre;
            pairs.push_back({i, k, length(centre - newcomer.seat->centre)});
        }
    }
    std::ranges::sort(pairs, {}, &Pair::distance);
    return pairs;
}

}  // namespace

std::vector<PlanRequest> seat_exchanges(const PlanRequest& request) {
    constexpr std::size_t max_exchanges = 4;
    std::vector<PlanRequest> exchanges;
    for (const Pair& pair : nearest_pairs(request)) {
        if (exchanges.size() == max_exchanges) break;
        const PlanItem& kept = request.items[pair.kept];
        PlanRequest& exchanged = exchanges.emplace_back(request);
        exchanged.items[pair.newcomer].seat = seat_of(kept.item, *kept.previous);
        exchanged.items[pair.kept].previous =
            placed_on(*request.items[pair.newcomer].seat, kept.item, request.max_scale);
        exchanged.items[pair.kept].home.reset();
    }
    return exchanges;
}

}  // namespace vitrine::player
