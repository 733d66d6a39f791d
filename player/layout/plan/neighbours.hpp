#pragma once

#include "player/layout/plan/plan_request.hpp"

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace vitrine::player {

using Neighbours = std::vector<std::pair<std::size_t, std::size_t>>;

/// The pairs of regions whose parts of the canvas touch, each once: every place belongs to the nearest
/// region.
/// @param regions  canvas px, convex
Neighbours neighbours_of(std::span<const Polygon> regions, Vec2 canvas);

/// The difference of two shots in [0, 1]: that of their colours, and half of it for shots of one moment.
/// Shots without a look differ by what unlike pictures do.
double unlikeness(const PlanItem& a, const PlanItem& b);

/// The mean difference of a layout's neighbours. 0: there are none.
double mean_unlikeness(const PlanRequest& request, const Layout& layout);

/// A layout in which like shots stand beside each other: shots change places where their regions have about
/// the same shape, and the wall settles. It gives up at most a few hundredths of what I-Regions cover. The
/// given layout is returned where no better one is found.
/// @param fresh  of this request, in which no item has a place
Layout with_alike_neighbours(const PlanRequest& request, const Layout& fresh, const PlanWatch& watch);

}  // namespace vitrine::player
