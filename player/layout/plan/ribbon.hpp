#pragma once

#include "player/layout/plan/plan_request.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace vitrine::player {

/// The endless canvas of a panning wall: fixed height, continued to the right while a screen passes along it.
/// Items left of `firm` are never moved again; items right of it are laid out, but may still make room for
/// newcomers.
struct Ribbon {
    Vec2 screen;  // px
    std::vector<LayoutItem> items;
    std::vector<Placement> placements;  // one an item, ribbon px: x to the right from the begin of the ribbon
    double firm = 0;                    // ribbon px
    double end = 0;                     // ribbon px; no I-Region reaches beyond
};

/// One extension of a ribbon: a screen's width of new items laid out ahead, on a window of two screens.
struct RibbonExtension {
    PlanRequest request;             // the window: items that stand pinned, loose and new ones free
    double origin = 0;               // begin of the window, ribbon px
    double end = 0;                  // end of the window, ribbon px
    std::vector<std::size_t> items;  // indices in the ribbon, in the order of the request; newcomers follow
    std::vector<LayoutItem> newcomers;
};

/// The number of newcomers that an extension wants, for so many items on a screen's width.
std::size_t wanted_newcomers(const Ribbon& ribbon, std::size_t items_a_screen);

/// @param rules  all of a request but its items and canvas
RibbonExtension extension(const Ribbon& ribbon, std::span<const LayoutItem> newcomers,
                          const PlanRequest& rules);

/// The ribbon with an extension laid out; its newcomers are the last items.
/// @param layout  of the extension's request
Ribbon extended(const Ribbon& ribbon, const RibbonExtension& extension, const Layout& layout);

/// A ribbon of finite length with all items, laid out from left to right.
/// @param width  px; the ribbon ends there
Layout ribbon_layout(std::span<const LayoutItem> items, Vec2 screen, double width, const PlanRequest& rules);

}  // namespace vitrine::player
