#include "player/layout/pack/initial_packing.hpp"

#include "player/layout/pack/energy.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace vitrine::player {

namespace {

constexpr int rays = 64;
constexpr int refinements = 8;  // golden sections of the angle between two rays
constexpr double touching = 1e-9;

/// A place for the next item.
struct Gap {
    Vec2 place;
    double screen = 0;    // px^2 of the smallest screen with this item
    double distance = 0;  // from the centre
};

bool is_better(const Gap& a, const Gap& b) {
    const double slack = 1e-9 * b.screen;
    return a.screen < b.screen - slack || (a.screen <= b.screen + slack && a.distance < b.distance);
}

/// Packs one item after another.
class RadialPacking {
  public:
    RadialPacking(const ScaledShapes& shapes, const Contacts& contacts, double ratio)
        : shapes_(shapes), contacts_(contacts), ratio_(ratio), places_(shapes.size()) {}

    void add(std::size_t item) {
        if (!placed_.empty()) places_[item] = best_gap(item).place;
        const Box extent = moved(shapes_.extent(item), places_[item]);
        bounds_ = placed_.empty() ? extent : united(bounds_, extent);
        placed_.push_back(item);
    }

    std::vector<Vec2> places() const { return places_; }

  private:
    /// The first gap on a ray.
    Gap gap(std::size_t item, double angle) {
        const Vec2 direction{std::cos(angle), std::sin(angle)};
        blocked_.clear();
        for (const std::size_t other : placed_) {
            const RayStretch stretch = contacts_.blocked_stretch(other, item, places_[other] * -1, direction);
            if (stretch.begin < stretch.end) blocked_.push_back(stretch);
        }
        std::sort(blocked_.begin(), blocked_.end(),
                  [](const RayStretch& a, const RayStretch& b) { return a.begin < b.begin; });
        double r = 0;
        for (const RayStretch& stretch : blocked_)
            if (stretch.begin <= r) r = std::max(r, stretch.end * (1 + touching) + touching);
        const Vec2 place = direction * r;
        const Box all = united(bounds_, moved(shapes_.extent(item), place));
        return {place, screen_area(all, ratio_), r};
    }

    Gap best_gap(std::size_t item) {
        constexpr double between = 2 * std::numbers::pi / rays;
        Gap best = gap(item, 0);
        double best_angle = 0;
        for (int k = 1; k < rays; ++k) {
            const Gap next = gap(item, k * between);
            if (!is_better(next, best)) continue;
            best = next;
            best_angle = k * between;
        }
        double low = best_angle - between;
        double high = best_angle + between;
        for (int i = 0; i < refinements; ++i) {
            const double shorter = (high - low) * (2 - std::numbers::phi);
            const Gap left = gap(item, low + shorter);
            const Gap right = gap(item, high - shorter);
            (is_better(left, right) ? high : low) = is_better(left, right) ? high - shorter : low + shorter;
            for (const Gap& next : {left, right})
                if (is_better(next, best)) best = next;
        }
        return best;
    }

    ScaledShapes shapes_;       // outlive this
    const Contacts& contacts_;  // outlives this
    double ratio_;
    std::vector<Vec2> places_;
    std::vector<std::size_t> placed_;
    std::vector<RayStretch> blocked_;  // blocked parts of one ray; a member, to reuse its memory
    Box bounds_;
};

}  // namespace

std::vector<Vec2> initial_packing(const ScaledShapes& shapes, const Contacts& contacts, double ratio,
                                  PackingOrder order) {
    std::vector<std::size_t> items(shapes.size());
    std::iota(items.begin(), items.end(), 0);
    if (order == PackingOrder::largest_first)
        std::stable_sort(items.begin(), items.end(),
                         [&](std::size_t a, std::size_t b) { return shapes.area(a) > shapes.area(b); });
    RadialPacking packing(shapes, contacts, ratio);
    for (const std::size_t item : items)
        packing.add(item);
    return packing.places();
}

}  // namespace vitrine::player
