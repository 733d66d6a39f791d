#include "player/layout/descent.hpp"

#include "base/geometry/overlap.hpp"
#include "player/layout/energy.hpp"

#include <algorithm>
#include <numeric>

namespace vitrine {

namespace {

constexpr auto unit_step = static_cast<std::int32_t>(grid_per_px);

/// A layout on the grid with the energy of its present state.
class Descent {
  public:
    Descent(std::span<const Shape> shapes, std::span<const double> scales, std::span<const Vec2> places,
            double ratio, EnergyMode mode)
        : areas_(outlines(shapes, scales, places)),
          places_(places.begin(), places.end()),
          ratio_(ratio),
          mode_(mode),
          centre_(areas_.bounds().centre()) {
        for (std::size_t i = 0; i < shapes.size(); ++i)
            weights_.push_back(shapes[i].area * scales[i] * scales[i]);
        now_ = energy();
        result_.first_energy = now_.empty;
    }

    /// Moves an item one step where that helps most.
    bool improve(std::size_t item, Effort& effort) {
        GridPoint best_way;
        ScreenEnergy best = now_;
        for (std::int32_t dx = -1; dx <= 1; ++dx)
            for (std::int32_t dy = -1; dy <= 1; ++dy) {
                if (dx == 0 && dy == 0) continue;
                move(item, {dx, dy});
                const ScreenEnergy there = energy();
                move(item, {-dx, -dy});
                effort.spend();
                if (!(there < best)) continue;
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
        result.last_energy = now_.empty;
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

    ScreenEnergy energy() const {
        const Measure measure{areas_.area(), areas_.overlap(), areas_.bounds()};
        if (mode_ == EnergyMode::paper) return {.hidden = 0, .empty = paper_energy(measure, ratio_)};
        ScreenEnergy energy{.hidden = measure.hidden / areas_.sum(),
                            .empty = 1 - measure.united / screen_area(measure.bounds, ratio_)};
        for (std::size_t i = 0; i < places_.size(); ++i) {
            const Vec2 d = places_[i] - centre_;
            energy.spread += weights_[i] * (d.x * d.x / ratio_ + ratio_ * d.y * d.y);
        }
        energy.spread /= areas_.sum() * areas_.sum();
        return energy;
    }

    UnionArea areas_;
    std::vector<Vec2> places_;
    std::vector<double> weights_;  // area, canvas px^2
    double ratio_;
    EnergyMode mode_;
    Vec2 centre_;
    ScreenEnergy now_;
    Descended result_;  // but for the places
};

}  // namespace

Descended descended(std::span<const Shape> shapes, std::span<const double> scales,
                    std::span<const Vec2> places, double ratio, EnergyMode mode, Random& random,
                    Effort& effort) {
    Descent descent(shapes, scales, places, ratio, mode);
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

}  // namespace vitrine
