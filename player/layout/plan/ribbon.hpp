#pragma once

#include "player/layout/plan/plan_request.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace vitrine::player {

/// The endless canvas of a panning wall: of fixed height, continued to the right while a screen moves along
/// it. Items left of `firm` are never moved again. Items right of it are laid out, but may still make room
/// for newcomers.
struct Ribbon {
    Vec2 screen;  // px
    std::vector<LayoutItem> items;
    std::vector<Placement> placements;  // one for each item, ribbon px: x counts from the ribbon's start
    double firm = 0;                    // ribbon px
    double end = 0;                     // ribbon px; limit of all I-Regions
};

/// One extension of a ribbon: new items for a screen's width, laid out ahead on a window of two screens.
struct RibbonExtension {
    PlanRequest request;             // the window: placed items are pinned, loose and new ones are free
    double origin = 0;               // start of the window, ribbon px
    double end = 0;                  // end of the window, ribbon px
    std::vector<std::size_t> items;  // indices in the ribbon, in the request's order, then the newcomers
    std::vector<LayoutItem> newcomers;
};

/// The number of newcomers for an extension, if this many items shall be on a screen's width.
std::size_t wanted_newcomers(const Ribbon& ribbon, std::size_t items_a_screen);

/// @param rules  a request without items and canvas
RibbonExtension extension(const Ribbon& ribbon, std::span<const LayoutItem> newcomers,
                          const PlanRequest& rules);

/// Adds an extension to a ribbon. The newcomers become the last items.
/// @param layout  the layout of the extension's request
Ribbon extended(const Ribbon& ribbon, const RibbonExtension& extension, const Layout& layout);

/// A ribbon of finite length with all items, laid out from left to right.
/// @param width  px of the ribbon
Layout ribbon_layout(std::span<const LayoutItem> items, Vec2 screen, double width, const PlanRequest& rules);

}  // namespace vitrine::player
