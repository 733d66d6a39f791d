#pragma once

#include "base/settings/choices.hpp"
#include "base/state/shot_look.hpp"
#include "player/layout/canvas.hpp"
#include "player/layout/layout.hpp"

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace vitrine::player {

/// A place on the wall that an item takes over from one that has left.
struct Seat {
    Vec2 centre;      // canvas px, centroid of the former I-Region
    double area = 0;  // canvas px^2 of the former I-Region; 0: the item gets its natural area

    bool operator==(const Seat&) const = default;
};

/// One item to be laid out, and its former place.
struct PlanItem {
    LayoutItem item;
    std::optional<Placement> previous;  // the item stays and should move little
    std::optional<Placement> home;      // the item returns to it as far as possible; none: to `previous`
    std::optional<Seat> seat;           // the item is new and takes over a seat; ignored with `previous`
    bool is_pinned = false;             // the item keeps `previous` exactly, even if pinned items overlap
    std::vector<Vec2> instead;  // of a pinned item: ways from `previous` to other places that it may take
                                // while no other item is placed; canvas px
    bool is_band = false;  // no item: a pinned box on which no I-Region may rest; plan/bands.hpp adds them
    std::optional<ShotLook> look = {};  // tells how like it is to others; none: not known
    std::optional<std::chrono::sys_time<std::chrono::milliseconds>> taken =
        {};                // by a camera; none: not known
    int group = no_group;  // items of one group are placed together, see plan/nesting.hpp

    static constexpr int no_group = -1;
};

/// True if an item keeps its place exactly.
bool has_pinned_place(const PlanItem& item);

/// The seat of a placed item, for its successor.
Seat seat_of(const LayoutItem& item, const Placement& placement);

/// The input of plan(). The same request gives the same layout.
struct PlanRequest {
    std::vector<PlanItem> items;
    Canvas canvas;  // px, both > 0
    std::uint64_t seed = 1;
    std::int64_t budget = 600'000;  // evaluated moves, 0.1 to 0.2 us each
    double clearance = 1.5;         // canvas px between I-Regions
    double margin = 0;              // canvas px between I-Regions and the canvas' edge
    double max_scale = 1.5;         // canvas px per source px; larger pictures look blurred
    bool fills = true;              // at last items are moved and resized so that pictures fill the canvas
    bool is_coarse = false;         // they are filled in few coarse steps, which are much alike from one plan
                                    // to the next
    EnergyMode energy = EnergyMode::screen;
    LayoutOrder order = LayoutOrder::free;              // ignored by the paper's energy
    NeighbourChoice neighbours = NeighbourChoice::any;  // of a new wall without groups, in free order
    bool keeps_places = false;  // where all items have a place, and these are sound, they are the layout
};

/// The observer of a plan in the making. Both functions may be empty.
struct PlanWatch {
    std::function<void(const Layout&)> on_better;  // gets complete layouts, free of overlap
    std::function<bool()> should_stop;             // called about every 1000 moves
};

}  // namespace vitrine::player
