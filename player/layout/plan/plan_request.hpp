#pragma once

#include "base/settings/choices.hpp"
#include "player/layout/layout.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace vitrine::player {

/// A place on the wall that an item takes over from one that left.
struct Seat {
    Vec2 centre;      // canvas px, centroid of the I-Region that stood there
    double area = 0;  // canvas px^2 of that I-Region; 0: the item's natural area
};

/// One item to be laid out, and where it stood before.
struct PlanItem {
    LayoutItem item;
    std::optional<Placement> previous;  // the item stays and should move little
    std::optional<Placement> home;      // the item goes back to it as far as it can; none: `previous`
    std::optional<Seat> seat;           // the item is new and takes over a seat; ignored with `previous`
    bool is_pinned = false;             // the item keeps `previous` exactly, even where pinned items overlap
    int group = no_group;               // items of one group stand together, see plan/nesting.hpp

    static constexpr int no_group = -1;
};

/// The seat that a placed item leaves behind.
Seat seat_of(const LayoutItem& item, const Placement& placement);

/// The input of plan(). The same request gives the same layout.
struct PlanRequest {
    std::vector<PlanItem> items;
    Vec2 canvas;  // px, both > 0
    std::uint64_t seed = 1;
    std::int64_t budget = 600'000;  // evaluated moves, 0.1 to 0.2 us each
    double clearance = 1.5;         // canvas px between I-Regions
    double margin = 1;              // canvas px between I-Regions and the canvas' edge
    double max_scale = 1.5;         // canvas px per source px: beyond it pictures look soft
    bool fills = true;              // at last items move and are resized so that pictures fill the canvas
    EnergyMode energy = EnergyMode::screen;
    LayoutOrder order = LayoutOrder::free;  // the paper's energy knows none
};

/// Who watches a plan being made. Both may be empty.
struct PlanWatch {
    std::function<void(const Layout&)> on_better;  // each is complete and free of overlap
    std::function<bool()> should_stop;             // asked about every 1000 moves
};

}  // namespace vitrine::player
