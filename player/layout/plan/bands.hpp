#pragma once

#include "player/layout/plan/plan_request.hpp"

#include <span>

namespace vitrine::player {

// A canvas of several outputs has bands that no output shows (canvas.hpp): bezels, and what lies beside
// smaller outputs. No I-Region rests there, as none rests outside the canvas. A search knows a band as one
// more pinned item. That holds only as far as the search succeeds. So each layout is checked, and if the
// check fails, each output is planned by itself: that always holds.

/// The area of all I-Regions in a layout, canvas px^2.
double covered_px(const PlanRequest& request, const Layout& layout);

/// The least clearance that a search keeps, canvas px; the grid of exact areas rounds by 1/512.
inline constexpr double min_clearance = 1.0 / 64;

/// True if a part of an item's I-Region is under a band.
bool is_under_band(const Canvas& canvas, const LayoutItem& item, const Placement& at);

/// True if no I-Region is under a band, but for pinned items.
/// @pre one placement for each item, or none
bool is_clear_of_bands(const PlanRequest& request, std::span<const Placement> placements);

/// The request with the bands as pinned items after the others. They are smaller by the clearance that a
/// search keeps from them, as far as they are wide enough.
PlanRequest with_bands(const PlanRequest& request);

/// A layout of such a request without the bands. @param request  without them
Layout without_bands(Layout layout, const PlanRequest& request);

/// The same for the layouts that a watch is told. @param watch, request  outlive the result
PlanWatch without_bands(const PlanWatch& watch, const PlanRequest& request);

}  // namespace vitrine::player
