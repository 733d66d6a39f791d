#include "player/layout/pack/coarse_filling.hpp"

#include <algorithm>
#include <vector>

namespace vitrine::player {

namespace {

constexpr double growths[] = {1, 1.1, 1.2, 1.3};  // factors of an item's scale
constexpr double ways[] = {0, 0.02, 0.05};        // shares of the field's diagonal
constexpr Vec2 directions[] = {{1, 0},     {0, 1},      {-1, 0},      {0, -1},
                               {0.7, 0.7}, {-0.7, 0.7}, {-0.7, -0.7}, {0.7, -0.7}};
constexpr double cost_of_growth = 0.02;  // share of the canvas that a growth to twice the size must fill
constexpr double cost_of_way = 0.1;      // the same for a step as long as the diagonal
constexpr double min_gain = 0.002;       // share of the canvas that a step must fill
constexpr int rounds = 2;
constexpr std::size_t max_items = 48;

/// The place and the scale of one item.
struct Step {
    Vec2 place;
    double scale = 1;
};

class CoarseFilling {
  public:
    CoarseFilling(PackingProblem& problem, std::span<const Box> frames, const Arrangement& start)
        : problem_(problem),
          frames_(frames),
          contacts_(problem.shapes, problem.clearance),
          now_{start.places, 1},
          diagonal_(length(problem.field.max - problem.field.min)) {
        problem_.scales = scales_at(problem, start.growth);
        contacts_.set_scales(problem_.scales);
        for (std::size_t i = 0; i < problem_.size(); ++i)
            starts_.push_back({now_.places[i], problem_.scales[i]});
    }

    Arrangement run() {
        for (int round = 0; round < rounds; ++round)
            for (std::size_t i = 0; i < problem_.size(); ++i)
                if (!problem_.pinned[i]) improve(i);
        return now_;
    }

  private:
    /// Takes the best step of an item from its start.
    void improve(std::size_t item) {
        const Step& start = starts_[item];
        Step best{now_.places[item], problem_.scales[item]};
        const double before = cost(item);
        double least = before - min_gain;
        for (const double growth : growths) {
            const double scale = std::max(start.scale, std::min(start.scale * growth, problem_.limits[item]));
            for (const double way : ways)
                for (const Vec2& direction : directions) {
                    const Step step{start.place + direction * (way * diagonal_), scale};
                    if (const double there = cost_at(item, step); there < least)
                        least = there, best = {now_.places[item], scale};
                    if (way == 0) break;  // all directions are one
                }
        }
        set(item, best);
    }

    /// The cost of a step; more than any other if the item may not take it.
    double cost_at(std::size_t item, const Step& step) {
        constexpr double forbidden = 1e9;
        set(item, step);
        set(item, {moved_into(step.place, problem_.place_range(item, 1)), step.scale});
        const bool is_allowed = is_allowed_place(problem_, contacts_, now_, item, now_.places[item]) &&
                                (!problem_.keeps_order || is_in_order(problem_, now_.places, 1));
        return is_allowed ? cost(item) : forbidden;
    }

    double cost(std::size_t item) const {
        const Step& start = starts_[item];
        return unfilled_share(problem_, frames_, now_) +
               cost_of_growth * (problem_.scales[item] / start.scale - 1) +
               cost_of_way * length(now_.places[item] - start.place) / diagonal_;
    }

    void set(std::size_t item, const Step& step) {
        now_.places[item] = step.place;
        problem_.scales[item] = step.scale;
        contacts_.set_scale(item, step.scale);
    }

    PackingProblem& problem_;  // outlives this
    std::span<const Box> frames_;
    Contacts contacts_;
    Arrangement now_;
    double diagonal_;  // canvas px
    std::vector<Step> starts_;
};

}  // namespace

Arrangement coarsely_filled(PackingProblem& problem, std::span<const Box> frames, const Arrangement& start) {
    if (problem.size() > max_items) return start;
    return CoarseFilling(problem, frames, start).run();
}

}  // namespace vitrine::player
