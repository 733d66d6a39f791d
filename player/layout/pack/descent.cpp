#include "player/layout/pack/descent.hpp"

#include "player/layout/pack/energy.hpp"
#include "player/layout/pack/overlap.hpp"

#include <algorithm>
#include <numeric>

namespace vitrine::player {

namespace {

constexpr auto unit_step = static_cast<std::int32_t>(grid_per_px);
constexpr double least_win = 1e-9;  // of ln E

/// A layout on the grid with the energy of its present state.
class Descent {
  public:
    Descent(std::span<const Shape> shapes, std::span<const double> scales, std::span<const Vec2> places,
            double ratio)
        : areas_(outlines(shapes, scales, places)),
          places_(places.begin(), places.end()),
          ratio_(ratio),
          now_(energy()) {
        result_.first_energy = now_;
    }

    /// Moves an item one step where that helps most.
    bool improve(std::size_t item, Effort& effort) {
        GridPoint best_way;
        double best = now_ - least_win;
        for (std::int32_t dx = -1; dx <= 1; ++dx)
            for (std::int32_t dy = -1; dy <= 1; ++dy) {
                if (dx == 0 && dy == 0) continue;
                move(item, {dx, dy});
                const double there = energy();
                move(item, {-dx, -dy});
                effort.spend();
                if (there >= best) continue;
                best = there;
                best_way = {dx, dy};
            }
        if (best_way == GridPoint{}) return false;
        move(item, best_way);
        now_ = best;
        ++result_.steps;
        return true;
    }

    Descended result() const {
        Descended result = result_;
        result.places = places_;
        result.last_energy = now_;
        return result;
    }

  private:
    static std::vector<GridPolygon> outlines(std::span<const Shape> shapes, std::span<const double> scales,
                                             std::span<const Vec2> places) {
        std::vector<GridPolygon> result;
        for (std::size_t i = 0; i < shapes.size(); ++i)
            result.push_back(snapped(transformed(shapes[i].outline, scales[i], places[i])));
        return result;
    }

    void move(std::size_t item, GridPoint steps) {
        areas_.move(item, {steps.x * unit_step, steps.y * unit_step});
        places_[item] = places_[item] + Vec2{static_cast<double>(steps.x), static_cast<double>(steps.y)};
    }

    double energy() const { return paper_energy({areas_.area(), areas_.overlap(), areas_.bounds()}, ratio_); }

    UnionArea areas_;
    std::vector<Vec2> places_;
    double ratio_;
    double now_;
    Descended result_;  // but for the places
};

}  // namespace

Descended descended(std::span<const Shape> shapes, std::span<const double> scales,
                    std::span<const Vec2> places, double ratio, Random& random, Effort& effort) {
    Descent descent(shapes, scales, places, ratio);
    std::vector<std::size_t> order(shapes.size());
    std::iota(order.begin(), order.end(), 0);
    bool any = true;
    while (any && !effort.is_spent()) {
        std::shuffle(order.begin(), order.end(), random);
        any = false;
        for (const std::size_t item : order)
            any = descent.improve(item, effort) || any;
    }
    return descent.result();
}

}  // namespace vitrine::player
