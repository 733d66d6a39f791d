#pragma once

#include "player/layout/layout.hpp"

#include <optional>
#include <span>
#include <vector>

namespace vitrine::player {

/// The way of items from one layout to another. Between two keys every placement's scale and offset change
/// linearly, so every corner of an I-Region moves on a straight line.
struct Motion {
    enum class Kind {
        still,     // no shot moves
        straight,  // all items at once
        staged,    // some items wait for others
        shrunk,    // some items are smaller during the motion
        detour,    // by way of a third layout
    };

    Kind kind = Kind::still;
    std::vector<std::vector<Placement>> keys;  // at equal intervals from 0 to 1; at least one
};

/// The placements at a time, which is clamped to [0, 1].
std::vector<Placement> placements_at(const Motion& motion, double time);

/// The times in (0, 1) at which the I-Regions of two items share inner points during a linear motion. The
/// sides keep their directions, so the gap along each side's normal is linear in time, and the regions
/// overlap while all gaps are negative. So it is one interval, exact but for rounding.
struct OverlapInterval {
    double begin = 1;
    double end = 0;

    bool is_empty() const { return begin >= end; }
};

/// A moving item with its two placements.
struct MovingItem {
    const LayoutItem& item;  // outlives the call
    Placement from;
    Placement to;
};

/// @param clearance  canvas px that the regions keep between them, >= 0
OverlapInterval overlap_interval(const MovingItem& a, const MovingItem& b, double clearance);

/// For each item that moves: the number of others that it meets on the straight way. For one that stands: -1.
/// @param from, to  one placement for each item
std::vector<int> meetings(std::span<const LayoutItem> items, std::span<const Placement> from,
                          std::span<const Placement> to);

/// The least scale of an item on its way; a smaller one is hard to follow.
constexpr double min_scale_on_way = 0.7;  // times the smaller of its two scales at rest

/// The least scale of an item during a motion, in shares of the smaller one of its two at rest.
double smallest_scale(const Motion& motion);

/// Returns the middle of what an item that leaves and one that comes have in common. Items that cross it
/// would hide both. None: they have so little in common that they are at two places.
/// @param common     canvas px, convex
/// @param seat_area  canvas px^2 of the smaller of both
std::optional<LayoutItem> guard_of_seat(const Polygon& common, double seat_area);

/// A motion of all items from one layout to another in which no I-Region ever covers another, and none is
/// smaller than min_scale_on_way allows. Tries in turn: all items at once, some after others, and then the
/// calmer way of two: some items smaller during the motion, or by way of a halfway layout. None: none of
/// these works, and only a crossfade is left.
///
/// @param from, to  free of overlap, one placement for each item
/// @param canvas    px; a region that is inside it in both layouts never leaves it
std::optional<Motion> motion_between(std::span<const LayoutItem> items, std::span<const Placement> from,
                                     std::span<const Placement> to, Vec2 canvas);

}  // namespace vitrine::player
