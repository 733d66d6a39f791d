#include "player/layout/pack/sliver_filling.hpp"

#include "player/layout/pack/filling.hpp"
#include "player/layout/pack/item_steps.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace vitrine::player {

namespace {

constexpr double growths[] = {1, 1.004, 1.012};     // factors of an item's scale
constexpr double ways[] = {0.0005, 0.0015, 0.004};  // shares of the canvas' diagonal
constexpr double max_gap = 0.015;   // share of the canvas' diagonal: a wider one at the edge is no sliver
constexpr double overshoot = 0.01;  // canvas px by which a frame reaches beyond the edge
constexpr double min_gain = 2e-5;   // share of the canvas that a step must fill: a line of 40 px in 1080p
constexpr int rounds = 2;
constexpr std::size_t max_items = 24;  // more pictures overlap so much that few slivers are left

class SliverFilling {
  public:
    SliverFilling(PackingProblem& problem, std::span<const Box> frames, const Arrangement& start)
        : items_(problem, frames, start),
          diagonal_(length(problem.whole().max - problem.whole().min)),
          empty_(unfilled()) {}

    Arrangement run() {
        items_.for_each_movable(rounds, [&](std::size_t item) {
            if (empty_ >= min_gain) improve(item);
        });
        return items_.now();
    }

  private:
    double unfilled() const { return exact_unfilled_share(items_.problem(), items_.frames(), items_.now()); }

    void improve(std::size_t item) {
        for (const Vec2 way : ways_to_edges(item))
            try_step(item, way, 1);
        const double scale = items_.at(item).scale;
        for (const double growth : growths)
            for (const double way : ways)
                for (const Vec2& direction : step_directions)
                    try_step(item, direction * (way * diagonal_), scale * growth / items_.at(item).scale);
    }

    /// The ways that take a frame's sides to edges of the canvas that they nearly reach.
    std::vector<Vec2> ways_to_edges(std::size_t item) const {
        const ItemStep now = items_.at(item);
        const Box& frame = items_.frames()[item];
        const Box& canvas = items_.problem().whole();
        const Vec2 low = now.place + frame.min * now.scale - canvas.min;
        const Vec2 high = canvas.max - now.place - frame.max * now.scale;
        std::vector<Vec2> found;
        const auto add = [&](double gap, Vec2 towards) {
            if (gap > 0 && gap <= max_gap * diagonal_) found.push_back(towards * (gap + overshoot));
        };
        add(low.x, {-1, 0});
        add(low.y, {0, -1});
        add(high.x, {1, 0});
        add(high.y, {0, 1});
        return found;
    }

    /// Takes a step if it is allowed and fills more.
    /// @param growth  factor of the item's scale
    void try_step(std::size_t item, Vec2 way, double growth) {
        const ItemStep before = items_.at(item);
        if (before.scale * growth > items_.problem().limits[item] && growth > 1) return;
        if (items_.try_step(item, {before.place + way, before.scale * std::max(growth, 1.0)}))
            if (const double there = unfilled(); there < empty_ - min_gain) {
                empty_ = there;
                return;
            }
        items_.set(item, before);
    }

    ItemSteps items_;
    double diagonal_;  // canvas px
    double empty_;     // share of the canvas
};

}  // namespace

Arrangement slivers_filled(PackingProblem& problem, std::span<const Box> frames, const Arrangement& start) {
    if (problem.size() == 0 || problem.size() > max_items) return start;
    return SliverFilling(problem, frames, start).run();
}

}  // namespace vitrine::player
