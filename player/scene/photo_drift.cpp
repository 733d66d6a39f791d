#include "player/scene/photo_drift.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace vitrine::player {

namespace {

using std::chrono::nanoseconds;

constexpr double touching_sides = 1.0 / 64;     // canvas px: sides that are so near touch one another
constexpr double outline_clearance = 1.0 / 16;  // canvas px that a region keeps from the outline of its cell
constexpr double edge_width = 1;                // canvas px that a cell's edge reaches beyond its outline
constexpr double max_way_share = 0.06;          // longest way to one side, as a share of the cell's mean side
constexpr double min_seen_way = 2;              // canvas px: nobody sees a shorter one
constexpr double keeps_direction = 0.5;         // share of the longest way
constexpr auto drift_period = std::chrono::seconds(60);
constexpr auto drift_step =
    std::chrono::milliseconds(100);  // between two places on a way: nobody sees a fifth
                                     // of a px, and a wall that stands is not drawn

struct Side {
    Vec2 a;
    Vec2 b;

    Vec2 outward() const { return {b.y - a.y, a.x - b.x}; }  // of a counter-clockwise outline; not normal
};

/// Calls `use` with the sides that look in a direction.
template <typename Use> void for_sides_ahead(const Polygon& outline, Vec2 direction, Use use) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Side side{outline[i], outline[(i + 1) % outline.size()]};
        if (dot(side.outward(), direction) > 1e-9 * length(side.b - side.a)) use(side);
    }
}

/// The way of a point in this direction until it meets a side. Infinite: it passes by.
double way_to(Vec2 point, Vec2 direction, const Side& side) {
    const Vec2 along = side.b - side.a;
    const double across = dot(side.outward(), direction);
    const double way = dot(side.outward(), side.a - point) / across;
    const double place = dot(point + direction * way - side.a, along);
    const double slack = touching_sides * length(along);
    const bool is_met = way > -touching_sides && place > -slack && place < dot(along, along) + slack;
    return is_met ? std::max(way, 0.0) : std::numeric_limits<double>::infinity();
}

/// True if no part of a region lies far beyond an outline, as where the canvas cuts it off.
bool is_around(const Polygon& outline, const Polygon& region) {
    const Box outer = bounding_box(outline);
    const Box inner = bounding_box(region);
    return inner.min.x > outer.min.x - touching_sides && inner.min.y > outer.min.y - touching_sides &&
           inner.max.x < outer.max.x + touching_sides && inner.max.y < outer.max.y + touching_sides;
}

/// The way of a convex region until it meets the outline around it.
double way_within(const Polygon& region, const Polygon& outline, Vec2 direction) {
    if (!is_around(outline, region)) return 0;
    double way = std::numeric_limits<double>::infinity();
    for_sides_ahead(outline, direction, [&](const Side& side) {
        for (const Vec2 corner : region)
            way = std::min(way, way_to(corner, direction, side));
    });
    // a corner of the outline that stands out into the cell meets a side of the region
    for_sides_ahead(region, direction, [&](const Side& side) {
        for (const Vec2 corner : outline)
            way = std::min(way, way_to(corner, direction * -1.0, side));
    });
    return way;
}

/// The way of the picture until one of its edges meets the cell.
double way_of_picture(const PlacedShot& placed, Vec2 direction) {
    Polygon corners;
    for (const Polygon& part : placed.cell->parts)
        corners.insert(corners.end(), part.begin(), part.end());
    double edge = edge_width;
    for (const FadeEdge& fade : placed.cell->fade_edges)
        for (const double width : fade.widths)
            edge = std::max(edge, width);
    const Box seen = bounding_box(corners);
    const Placement& at = placed.placement;
    const Vec2 least = seen.min - (placed.shot.item.core.min * at.scale + at.offset);
    const Vec2 most = placed.shot.item.core.max * at.scale + at.offset - seen.max;
    double way = std::numeric_limits<double>::infinity();
    const auto limit = [&](double room, double speed) {
        if (speed > 1e-9) way = std::min(way, std::max(0.0, room - edge) / speed);
    };
    limit(least.x, direction.x);
    limit(most.x, -direction.x);
    limit(least.y, direction.y);
    limit(most.y, -direction.y);
    return way;
}

/// The times in which one stretch meets another that moves to it.
struct Meeting {
    double begin = -std::numeric_limits<double>::infinity();
    double end = std::numeric_limits<double>::infinity();

    /// @param gaps  from the moving stretch to the ends of the other one, along an axis
    void narrow(double first_gap, double last_gap, double speed) {
        if (std::abs(speed) < 1e-9) {
            if (first_gap >= 0 || last_gap <= 0) end = begin;  // they pass one another
            return;
        }
        begin = std::max(begin, std::min(first_gap / speed, last_gap / speed));
        end = std::min(end, std::max(first_gap / speed, last_gap / speed));
    }
};

/// The way of the box around a region until it meets a band.
double way_to_bands(const PlacedShot& placed, std::span<const Box> bands, Vec2 direction) {
    const Box region = bounding_box(placed_region(placed.shot.item, placed.placement));
    double way = std::numeric_limits<double>::infinity();
    for (const Box& band : bands) {
        Meeting meeting;
        meeting.narrow(band.min.x - region.max.x, band.max.x - region.min.x, direction.x);
        meeting.narrow(band.min.y - region.max.y, band.max.y - region.min.y, direction.y);
        if (meeting.begin < meeting.end && meeting.end > 0)
            way = std::min(way, std::max(0.0, meeting.begin - outline_clearance));
    }
    return way;
}

/// A photo whose drift is looked for, and the longest way to one side.
struct DriftRoom {
    const PlacedShot& placed;
    std::span<const Box> bands;
    double max_way = 0;

    double way(Vec2 direction) const {
        return std::min({free_way(placed, direction), way_to_bands(placed, bands, direction), max_way});
    }
};

PhotoDrift drift_along(const DriftRoom& room, Vec2 direction) {
    return {.from = direction * -room.way(direction * -1.0), .to = direction * room.way(direction)};
}

double length_of(const PhotoDrift& drift) {
    return length(drift.to - drift.from);
}

PhotoDrift longest_drift(const PlacedShot& placed, const PlacedShot* before, std::span<const Box> bands) {
    constexpr int directions = 8;
    double size = 0;
    for (const Polygon& part : placed.cell->parts)
        size += signed_area(part);
    const DriftRoom room{placed, bands, max_way_share * std::sqrt(std::max(size, 0.0))};
    PhotoDrift best;
    for (int k = 0; k < directions; ++k) {
        const double angle = std::numbers::pi * k / directions;
        const PhotoDrift drift = drift_along(room, {std::cos(angle), std::sin(angle)});
        if (length_of(drift) > length_of(best)) best = drift;
    }
    if (before != nullptr && length_of(before->drift) > 0) {
        const Vec2 kept = (before->drift.to - before->drift.from) * (1 / length_of(before->drift));
        const PhotoDrift drift = drift_along(room, kept);
        if (length_of(drift) >= keeps_direction * length_of(best)) best = drift;
    }
    return length_of(best) >= min_seen_way ? best : PhotoDrift{};
}

/// The place on a way at a time.
Vec2 place_on(const PhotoDrift& way, SourceId source, nanoseconds now) {
    constexpr double apart = 2.399963;  // the golden angle: no two photos go together
    const double turns = std::chrono::duration<double>(now / drift_step * drift_step) /
                         std::chrono::duration<double>(drift_period);
    const double wave =
        std::sin(2 * std::numbers::pi * turns + apart * static_cast<double>(source % 1'000'000));
    return (wave > 0 ? way.to : way.from) * (wave * wave);  // it rests for a moment in the middle
}

}  // namespace

double free_way(const PlacedShot& placed, Vec2 direction) {
    if (!placed.cell || placed.cell->parts.empty()) return 0;
    const Polygon region = placed_region(placed.shot.item, placed.placement);
    const double way = std::min(way_within(region, placed.cell->parts[0], direction) - outline_clearance,
                                way_of_picture(placed, direction));
    return std::isfinite(way) ? std::max(0.0, way) : 0;
}

void give_drifts(std::span<PlacedShot> wall, std::span<const PlacedShot> before, std::span<const Box> bands) {
    for (PlacedShot& placed : wall) {
        placed.drift = {};
        if (placed.shot.kind == MediaKind::photo && placed.cell)
            placed.drift = longest_drift(placed, find_source(before, placed.shot.source), bands);
    }
}

Vec2 drift_at(const PlacedShot& placed, nanoseconds now) {
    return place_on(placed.drift, placed.shot.source, now);
}

Vec2 drift_within_cell(const PlacedShot& placed, const PhotoDrift& way, double share, nanoseconds now) {
    const Vec2 wish = place_on(way, placed.shot.source, now) * share;
    const double distance = length(wish);
    if (distance <= 0) return {};
    return wish * (std::min(distance, free_way(placed, wish * (1 / distance))) / distance);
}

}  // namespace vitrine::player
