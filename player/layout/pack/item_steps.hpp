#pragma once

#include "player/layout/pack/arrangement.hpp"

#include <cstddef>
#include <span>

namespace vitrine::player {

/// The place and the scale of one item.
struct ItemStep {
    Vec2 place;  // canvas px, centroid
    double scale = 1;
};

/// The directions of steps, of about the same length.
inline constexpr Vec2 step_directions[] = {{1, 0},     {0, 1},      {-1, 0},      {0, -1},
                                           {0.7, 0.7}, {-0.7, 0.7}, {-0.7, -0.7}, {0.7, -0.7}};

/// An arrangement that is changed by steps of single items, so that frames fill the canvas. Nothing is
/// random.
class ItemSteps {
  public:
    /// @param problem  outlives this; gets the scales of the arrangement
    /// @param frames   one for each item, source px from the centroid of its region; outlives this
    /// @param start    free of overlap
    ItemSteps(PackingProblem& problem, std::span<const Box> frames, const Arrangement& start);

    /// Calls `improve` with each item that may move, some rounds of all.
    template <typename Improve> void for_each_movable(int rounds, Improve improve) {
        for (int round = 0; round < rounds; ++round)
            for (std::size_t i = 0; i < problem_.size(); ++i)
                if (!problem_.pinned[i]) improve(i);
    }

    ItemStep at(std::size_t item) const { return {now_.places[item], problem_.scales[item]}; }

    void set(std::size_t item, const ItemStep& step);

    /// Sets an item to a step, or to the nearest place inside the field.
    /// @return true: it is free there, and in order if the order matters
    bool try_step(std::size_t item, const ItemStep& step);

    const Arrangement& now() const { return now_; }

    const PackingProblem& problem() const { return problem_; }

    std::span<const Box> frames() const { return frames_; }

  private:
    PackingProblem& problem_;  // outlives this
    std::span<const Box> frames_;
    Contacts contacts_;
    Arrangement now_;
};

}  // namespace vitrine::player
