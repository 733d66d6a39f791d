#include "player/layout/pack/descent.hpp"

#include "player/layout/pack/energy.hpp"
#include "player/layout/pack/overlap.hpp"

#include <algorithm>
#include <numeric>

namespace vitrine::player {

namespace {

constexpr auto unit_step = static_cast<std::int32_t>(grid_per_px);
constexpr double min_gain = 1e-9;  // in ln E

/// A layout on the grid with its present energy.
class Descent {
  public:
    Descent(const ScaledShapes& shapes, std::span<const Vec2> places, double ratio)
        : areas_(outlines(shapes, places)),
          places_(places.begin(), places.end()),
          ratio_(ratio),
          now_(energy()) {
        result_.first_energy = now_;
    }

    /// Moves an item one step in the direction that lowers the energy most. @return true: it has moved
    bool improve(std::size_t item, SearchBudget& budget) {
        GridPoint best_way;
        double best = now_ - min_gain;
        for (std::int32_t dx = -1; dx <= 1; ++dx)
            for (std::int32_t dy = -1; dy <= 1; ++dy) {
                if (dx == 0 && dy == 0) continue;
                move(item, {dx, dy});
                const double there = energy();
                move(item, {-dx, -dy});
                budget.spend();
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

    DescentResult result() const {
        DescentResult result = result_;
        result.places = places_;
        result.last_energy = now_;
        return result;
    }

  private:
    static std::vector<GridPolygon> outlines(const ScaledShapes& shapes, std::span<const Vec2> places) {
        std::vector<GridPolygon> result;
        for (std::size_t i = 0; i < shapes.size(); ++i)
            result.push_back(snapped(transformed(shapes.shapes[i].outline, shapes.scales[i], places[i])));
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
    DescentResult result_;  // complete but for the places
};

}  // namespace

DescentResult descend(const ScaledShapes& shapes, std::span<const Vec2> places, double ratio, Random& random,
                      SearchBudget& budget) {
    Descent descent(shapes, places, ratio);
    std::vector<std::size_t> order(shapes.size());
    std::iota(order.begin(), order.end(), 0);
    bool any = true;
    while (any && !budget.is_spent()) {
        std::shuffle(order.begin(), order.end(), random);
        any = false;
        for (const std::size_t item : order)
            any = descent.improve(item, budget) || any;
    }
    return descent.result();
}

}  // namespace vitrine::player
