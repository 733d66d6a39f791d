#include "player/layout/pack/coarse_filling.hpp"

#include "player/layout/pack/item_steps.hpp"

#include <algorithm>
#include <vector>

namespace vitrine::player {

namespace {

constexpr double growths[] = {1, 1.1, 1.2, 1.3};  // factors of an item's scale
constexpr double ways[] = {0, 0.02, 0.05};        // shares of the field's diagonal
constexpr double cost_of_growth = 0.02;  // share of the canvas that a growth to twice the size must fill
constexpr double cost_of_way = 0.1;      // the same for a step as long as the diagonal
constexpr double min_gain = 0.002;       // share of the canvas that a step must fill
constexpr int rounds = 2;
constexpr std::size_t max_items = 48;

class CoarseFilling {
  public:
    CoarseFilling(PackingProblem& problem, std::span<const Box> frames, const Arrangement& start)
        : items_(problem, frames, start), diagonal_(length(problem.field.max - problem.field.min)) {
        for (std::size_t i = 0; i < problem.size(); ++i)
            starts_.push_back(items_.at(i));
    }

    Arrangement run() {
        items_.for_each_movable(rounds, [&](std::size_t item) { improve(item); });
        return items_.now();
    }

  private:
    /// Takes the best step of an item from its start.
    void improve(std::size_t item) {
        const ItemStep& start = starts_[item];
        const double limit = items_.problem().limits[item];
        ItemStep best = items_.at(item);
        double least = cost(item) - min_gain;
        for (const double growth : growths) {
            const double scale = std::max(start.scale, std::min(start.scale * growth, limit));
            for (const double way : ways)
                for (const Vec2& direction : step_directions) {
                    const bool is_free =
                        items_.try_step(item, {start.place + direction * (way * diagonal_), scale});
                    if (const double there = is_free ? cost(item) : least; there < least)
                        least = there, best = items_.at(item);
                    if (way == 0) break;  // all directions are one
                }
        }
        items_.set(item, best);
    }

    double cost(std::size_t item) const {
        const ItemStep& start = starts_[item];
        const ItemStep now = items_.at(item);
        return unfilled_share(items_.problem(), items_.frames(), items_.now()) +
               cost_of_growth * (now.scale / start.scale - 1) +
               cost_of_way * length(now.place - start.place) / diagonal_;
    }

    ItemSteps items_;
    double diagonal_;  // canvas px
    std::vector<ItemStep> starts_;
};

}  // namespace

Arrangement coarsely_filled(PackingProblem& problem, std::span<const Box> frames, const Arrangement& start) {
    if (problem.size() > max_items) return start;
    return CoarseFilling(problem, frames, start).run();
}

}  // namespace vitrine::player
