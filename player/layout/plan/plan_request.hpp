#pragma once

#include "base/settings/choices.hpp"
#include "player/layout/layout.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace vitrine::player {

/// A place on the wall that an item takes over from one that left.
struct Seat {
    Vec2 centre;      // canvas px, centroid of the I-Region that stood there
    double area = 0;  // canvas px^2 of that I-Region; 0: what the item has by nature
};

/// One item to be laid out, and what it was doing before.
struct PlanItem {
    LayoutItem item;
    std::optional<Placement> previous;  // it stays and should move little
    std::optional<Placement> home;      // where it goes back to as far as it can; none: `previous`
    std::optional<Seat> seat;           // it is new and takes over a seat; ignored with `previous`
    bool is_pinned = false;             // it keeps `previous` exactly, even where pinned items overlap
    int group = no_group;  // those of one group stand together, see player/layout/plan/nesting.hpp

    static constexpr int no_group = -1;
};

/// The seat that a placed item leaves behind.
Seat seat_of(const LayoutItem& item, const Placement& placement);

/// What is asked of the planner. The same request gives the same layout.
struct PlanRequest {
    std::vector<PlanItem> items;
    Vec2 canvas;  // px, both > 0
    std::uint64_t seed = 1;
    std::int64_t budget = 600'000;  // evaluated moves, 0.1 to 0.2 us each
    double clearance = 1.5;         // canvas px between I-Regions
    double margin = 1;              // canvas px between I-Regions and the canvas' edge
    double most_scale = 1.5;        // canvas px per source px: beyond it pictures look soft
    bool fills = true;              // at last pictures fill the canvas, items move and are resized for it
    EnergyMode energy = EnergyMode::screen;
    LayoutOrder order = LayoutOrder::free;  // the paper's energy knows none
};

}  // namespace vitrine::player
