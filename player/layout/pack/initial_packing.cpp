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

struct Spot {
    Vec2 place;
    double screen = 0;    // px^2 of screen that the layout then needs
    double distance = 0;  // from the centre
};

bool is_better(const Spot& a, const Spot& b) {
    const double slack = 1e-9 * b.screen;
    return a.screen < b.screen - slack || (a.screen <= b.screen + slack && a.distance < b.distance);
}

Box placed_extent(const Shape& shape, double scale, Vec2 place) {
    return {shape.extent.min * scale + place, shape.extent.max * scale + place};
}

/// Packs one item after the other.
class RadialPacking {
  public:
    RadialPacking(std::span<const Shape> shapes, const Contacts& contacts, std::span<const double> scales,
                  double ratio)
        : shapes_(shapes), contacts_(contacts), scales_(scales), ratio_(ratio), places_(shapes.size()) {}

    void add(std::size_t item) {
        if (!placed_.empty()) places_[item] = best_spot(item).place;
        const Box extent = placed_extent(shapes_[item], scales_[item], places_[item]);
        bounds_ = placed_.empty() ? extent : united(bounds_, extent);
        placed_.push_back(item);
    }

    std::vector<Vec2> places() const { return places_; }

  private:
    Spot spot(std::size_t item, double angle) {
        const Vec2 direction{std::cos(angle), std::sin(angle)};
        blocked_.clear();
        for (const std::size_t other : placed_) {
            const Stretch stretch = contacts_.blocked(other, item, places_[other] * -1, direction);
            if (stretch.begin < stretch.end) blocked_.push_back(stretch);
        }
        std::sort(blocked_.begin(), blocked_.end(),
                  [](const Stretch& a, const Stretch& b) { return a.begin < b.begin; });
        double r = 0;
        for (const Stretch& stretch : blocked_)
            if (stretch.begin <= r) r = std::max(r, stretch.end * (1 + touching) + touching);
        const Vec2 place = direction * r;
        const Box all = united(bounds_, placed_extent(shapes_[item], scales_[item], place));
        return {place, screen_area(all, ratio_), r};
    }

    Spot best_spot(std::size_t item) {
        constexpr double between = 2 * std::numbers::pi / rays;
        Spot best = spot(item, 0);
        double best_angle = 0;
        for (int k = 1; k < rays; ++k) {
            const Spot next = spot(item, k * between);
            if (!is_better(next, best)) continue;
            best = next;
            best_angle = k * between;
        }
        double low = best_angle - between;
        double high = best_angle + between;
        for (int i = 0; i < refinements; ++i) {
            const double shorter = (high - low) * (2 - std::numbers::phi);
            const Spot left = spot(item, low + shorter);
            const Spot right = spot(item, high - shorter);
            (is_better(left, right) ? high : low) = is_better(left, right) ? high - shorter : low + shorter;
            for (const Spot& next : {left, right})
                if (is_better(next, best)) best = next;
        }
        return best;
    }

    std::span<const Shape> shapes_;
    const Contacts& contacts_;  // outlives this
    std::span<const double> scales_;
    double ratio_;
    std::vector<Vec2> places_;
    std::vector<std::size_t> placed_;
    std::vector<Stretch> blocked_;  // of one ray; kept for its memory
    Box bounds_;
};

}  // namespace

Box bounds_of(std::span<const Shape> shapes, std::span<const double> scales, std::span<const Vec2> places) {
    Box all;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const Box extent = placed_extent(shapes[i], scales[i], places[i]);
        all = i == 0 ? extent : united(all, extent);
    }
    return all;
}

std::vector<Vec2> initial_packing(std::span<const Shape> shapes, const Contacts& contacts,
                                  std::span<const double> scales, double ratio, PackingOrder order) {
    std::vector<std::size_t> items(shapes.size());
    std::iota(items.begin(), items.end(), 0);
    const auto area = [&](std::size_t i) { return shapes[i].area * scales[i] * scales[i]; };
    if (order == PackingOrder::largest_first)
        std::stable_sort(items.begin(), items.end(),
                         [&](std::size_t a, std::size_t b) { return area(a) > area(b); });
    RadialPacking packing(shapes, contacts, scales, ratio);
    for (const std::size_t item : items)
        packing.add(item);
    return packing.places();
}

}  // namespace vitrine::player
