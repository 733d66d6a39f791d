#pragma once

#include "player/layout/layout.hpp"

#include <optional>
#include <span>
#include <vector>

namespace vitrine::player {

/// The way of items from one layout to another. Between two keys every placement's scale and offset change
/// evenly, so every corner of an I-Region runs straight.
struct Motion {
    enum class Kind {
        still,     // no shot moves
        straight,  // all at once
        staged,    // some wait for others
        shrunk,    // some are smaller on the way
        detour,    // by way of a third layout
    };

    Kind kind = Kind::still;
    std::vector<std::vector<Placement>> keys;  // at even times from 0 to 1; at least one
};

/// The placements at a time in [0, 1]; clamps.
std::vector<Placement> placements_at(const Motion& motion, double time);

/// The times in (0, 1) at which the I-Regions of two items share inner points while both move evenly: since
/// the sides keep their directions, the gap along each side's normal is linear in time, and the regions
/// overlap while all those gaps are negative. So it is one interval, and exact but for rounding.
struct OverlapInterval {
    double begin = 1;
    double end = 0;

    bool is_empty() const { return begin >= end; }
};

/// An item on the way between two placements.
struct MovingItem {
    const LayoutItem& item;  // outlives the call
    Placement from;
    Placement to;
};

/// @param clearance  canvas px that the regions are kept apart beyond touching, >= 0
OverlapInterval overlap_interval(const MovingItem& a, const MovingItem& b, double clearance);

/// A motion of all items from one layout to another during which no I-Region ever covers another. Tries all
/// at once, then some after others, then smaller on the way, then by way of a layout halfway. None where none
/// of these works: then only a crossfade remains.
///
/// @param from, to  free of overlap, as many as items
/// @param canvas    px; no region leaves it that is inside in both layouts
std::optional<Motion> motion_between(std::span<const LayoutItem> items, std::span<const Placement> from,
                                     std::span<const Placement> to, Vec2 canvas);

}  // namespace vitrine::player
