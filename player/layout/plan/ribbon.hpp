#pragma once

#include "player/layout/plan/plan_request.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace vitrine::player {

/// A wall of fixed height that goes on to the right while a screen passes along it. What stands left of
/// `firm` is never moved again; what is right of it has been laid out, but may still make room for what
/// comes.
struct Strip {
    Vec2 screen;  // px
    std::vector<LayoutItem> items;
    std::vector<Placement> placements;  // one an item, strip px: x to the right from where the strip began
    double firm = 0;                    // strip px
    double end = 0;                     // strip px; no I-Region reaches beyond
};

/// One extension of a strip: a screen's width of new items laid out ahead, on a window of two screens.
struct StripExtension {
    PlanRequest request;             // the window: items that stand pinned, loose and new ones free
    double origin = 0;               // of the window, strip px
    double end = 0;                  // of the window, strip px
    std::vector<std::size_t> items;  // of the strip, in the order of the request; newcomers follow
    std::vector<LayoutItem> newcomers;
};

/// How many newcomers an extension wants, for so many items on a screen's width.
std::size_t wanted_newcomers(const Strip& strip, std::size_t items_a_screen);

/// @param rules  all of a request but its items and canvas
StripExtension extension(const Strip& strip, std::span<const LayoutItem> newcomers, const PlanRequest& rules);

/// The strip with an extension laid out; its newcomers are the last items.
/// @param layout  of the extension's request
Strip extended(const Strip& strip, const StripExtension& extension, const Layout& layout);

/// A strip of finite length, laid out from left to right. For as many items as there are.
/// @param width  px; the strip ends there
Layout strip_layout(std::span<const LayoutItem> items, Vec2 screen, double width, const PlanRequest& rules);

}  // namespace vitrine::player
