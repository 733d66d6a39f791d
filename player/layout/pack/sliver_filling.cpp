#include "player/layout/pack/sliver_filling.hpp"

#include "player/layout/pack/filling.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace vitrine::player {

namespace {

constexpr double growths[] = {1, 1.004, 1.012};     // factors of an item's scale
constexpr double ways[] = {0.0005, 0.0015, 0.004};  // shares of the canvas' diagonal
constexpr Vec2 directions[] = {{1, 0},     {0, 1},      {-1, 0},      {0, -1},
                               {0.7, 0.7}, {-0.7, 0.7}, {-0.7, -0.7}, {0.7, -0.7}};
constexpr double max_gap = 0.015;   // share of the canvas' diagonal: a wider one at the edge is no sliver
constexpr double overshoot = 0.01;  // canvas px by which a frame reaches beyond the edge
constexpr double min_gain = 2e-5;   // share of the canvas that a step must fill: a line of 40 px in 1080p
constexpr int rounds = 2;
constexpr std::size_t max_items = 24;  // more pictures overlap so much that few slivers are left

class SliverFilling {
  public:
    SliverFilling(PackingProblem& problem, std::span<const Box> frames, const Arrangement& start)
        : problem_(problem),
          frames_(frames),
          contacts_(problem.shapes, problem.clearance),
          now_{start.places, 1},
          diagonal_(length(problem.whole().max - problem.whole().min)) {
        problem_.scales = scales_at(problem, start.growth);
        contacts_.set_scales(problem_.scales);
        empty_ = exact_unfilled_share(problem_, frames_, now_);
    }

    Arrangement run() {
        for (int round = 0; round < rounds; ++round)
            for (std::size_t i = 0; i < problem_.size(); ++i)
                if (!problem_.pinned[i] && empty_ >= min_gain) improve(i);
        return now_;
    }

  private:
    void improve(std::size_t item) {
        for (const Vec2 way : ways_to_edges(item))
            try_step(item, way, 1);
        const double scale = problem_.scales[item];
        for (const double growth : growths)
            for (const double way : ways)
                for (const Vec2& direction : directions)
                    try_step(item, direction * (way * diagonal_), scale * growth / problem_.scales[item]);
    }

    /// The ways that take a frame's sides to edges of the canvas that they nearly reach.
    std::vector<Vec2> ways_to_edges(std::size_t item) const {
        const double scale = problem_.scales[item];
        const Box& canvas = problem_.whole();
        const Vec2 low = now_.places[item] + frames_[item].min * scale - canvas.min;
        const Vec2 high = canvas.max - now_.places[item] - frames_[item].max * scale;
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
        const Vec2 place = now_.places[item];
        const double scale = problem_.scales[item];
        if (scale * growth > problem_.limits[item] && growth > 1) return;
        set(item, place, scale * std::max(growth, 1.0));
        now_.places[item] = moved_into(place + way, problem_.place_range(item, 1));
        const bool is_allowed = is_allowed_place(problem_, contacts_, now_, item, now_.places[item]) &&
                                (!problem_.keeps_order || is_in_order(problem_, now_.places, 1));
        if (is_allowed) {
            const double there = exact_unfilled_share(problem_, frames_, now_);
            if (there < empty_ - min_gain) {
                empty_ = there;
                return;
            }
        }
        set(item, place, scale);
    }

    void set(std::size_t item, Vec2 place, double scale) {
        now_.places[item] = place;
        problem_.scales[item] = scale;
        contacts_.set_scale(item, scale);
    }

    PackingProblem& problem_;  // outlives this
    std::span<const Box> frames_;
    Contacts contacts_;
    Arrangement now_;
    double diagonal_;   // canvas px
    double empty_ = 0;  // share of the canvas
};

}  // namespace

Arrangement slivers_filled(PackingProblem& problem, std::span<const Box> frames, const Arrangement& start) {
    if (problem.size() == 0 || problem.size() > max_items) return start;
    return SliverFilling(problem, frames, start).run();
}

}  // namespace vitrine::player
