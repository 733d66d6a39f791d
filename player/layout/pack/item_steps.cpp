#include "player/layout/pack/item_steps.hpp"

namespace vitrine::player {

ItemSteps::ItemSteps(PackingProblem& problem, std::span<const Box> frames, const Arrangement& start)
    : problem_(problem),
      frames_(frames),
      contacts_(problem.shapes, problem.clearance),
      now_{start.places, 1} {
    problem_.scales = scales_at(problem, start.growth);
    contacts_.set_scales(problem_.scales);
}

void ItemSteps::set(std::size_t item, const ItemStep& step) {
    now_.places[item] = step.place;
    problem_.scales[item] = step.scale;
    contacts_.set_scale(item, step.scale);
}

bool ItemSteps::try_step(std::size_t item, const ItemStep& step) {
    set(item, step);
    now_.places[item] = moved_into(step.place, problem_.place_range(item, 1));
    return is_allowed_place(problem_, contacts_, now_, item, now_.places[item]) &&
           (!problem_.keeps_order || is_in_order(problem_, now_.places, 1));
}

}  // namespace vitrine::player
