#pragma once

#include "player/layout/plan/plan_request.hpp"

#include <functional>
#include <optional>

namespace vitrine::player {

using PlanFunction = std::function<Layout(const PlanRequest& request, const PlanWatch& watch)>;

/// Shares the items out to the outputs, those of a group together, by the sizes that they wish for, and plans
/// each output by itself. An item that has a place or a seat stays on its output. Pinned items keep their
/// places.
Layout plan_by_outputs(const PlanRequest& request, const PlanWatch& watch, const PlanFunction& plan);

/// The same with the best of some ways to share the items out. What has a place may come to another output.
Layout best_plan_by_outputs(const PlanRequest& request, const PlanWatch& watch, const PlanFunction& plan);

/// A change of a wall, each output by itself. An output to which nothing comes, and which is full, stays as
/// it is. None: an output would be left with a hole.
std::optional<Layout> change_by_outputs(const PlanRequest& request, const PlanWatch& watch,
                                        const PlanFunction& plan);

/// The share of what is seen of the canvas that no picture reaches, sampled.
double unseen_share(const PlanRequest& request, const Layout& layout);

/// The cost of a layout on what is seen of the canvas: smaller is better. Empty parts and uneven sizes cost,
/// I-Regions save. Sizes count less than in the filling (pack/filling.hpp): items shared out to outputs
/// cannot all get their fair size.
double cost_of_plan(const PlanRequest& request, const Layout& layout);

}  // namespace vitrine::player
