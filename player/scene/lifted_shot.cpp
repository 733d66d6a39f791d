#include "player/scene/lifted_shot.hpp"

#include "player/layout/cells/cut_cell.hpp"
#include "player/scene/crossfade.hpp"
#include "player/scene/photo_drift.hpp"
#include "player/scene/wall_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <vector>

namespace vitrine::player {

namespace {

constexpr int rays = 96;  // from the region's middle to the outline

Placement between(const Placement& a, const Placement& b, double share) {
    return {a.scale + (b.scale - a.scale) * share, a.offset + (b.offset - a.offset) * share};
}

/// The distance from a point inside an outline to the outline in a direction. A ray may cross it more than
/// once: the farthest crossing counts.
double reach_of(const Polygon& outline, Vec2 point, Vec2 direction) {
    double reach = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 a = outline[i] - point;
        const Vec2 side = outline[(i + 1) % outline.size()] - outline[i];
        const double slope = cross(direction, side);
        if (std::abs(slope) < std::numeric_limits<double>::epsilon()) continue;
        const double along_side = cross(a, direction) / slope;
        if (along_side < 0 || along_side > 1) continue;
        reach = std::max(reach, cross(a, side) / slope);
    }
    return reach;
}

/// The directions from a point to evenly spaced places and to the corners of both outlines.
std::vector<double> angles_of(const Polygon& small, const Polygon& large, Vec2 point) {
    std::vector<double> angles;
    angles.reserve(rays + small.size() + large.size());
    for (int k = 0; k < rays; ++k)
        angles.push_back((2.0 * k / rays - 1) * std::numbers::pi);
    for (const Polygon* outline : {&small, &large})
        for (const Vec2 corner : *outline)
            angles.push_back(std::atan2(corner.y - point.y, corner.x - point.x));
    std::ranges::sort(angles);
    return angles;
}

/// An outline on the way from one to the other, as triangles about a point inside both.
Cell opened(const Polygon& small, const Polygon& large, Vec2 point, double share) {
    Polygon outline;
    for (const double angle : angles_of(small, large, point)) {
        const Vec2 direction{std::cos(angle), std::sin(angle)};
        const double least = reach_of(small, point, direction);
        const double most = reach_of(large, point, direction);
        outline.push_back(point + direction * (least + (most - least) * share));
    }
    Cell cell;
    for (std::size_t i = 0; i < outline.size(); ++i)
        cell.triangles.push_back({point, outline[i], outline[(i + 1) % outline.size()]});
    cell.parts.push_back(std::move(outline));
    return cell;
}

}  // namespace

Box whole_picture(const WallShot& shot) {
    return shot.active.is_empty() ? Box{{0, 0}, shot.picture} : shot.active;
}

Placement fitting(const WallShot& shot, const Box& room, double share, Vec2 centre) {
    const Box whole = whole_picture(shot);
    const double scale = share * std::min(room.width() / whole.width(), room.height() / whole.height());
    const Vec2 half = (whole.max - whole.min) * (scale / 2);
    const Vec2 least = room.min + half;
    const Vec2 most = room.max - half;
    const Vec2 middle{std::clamp(centre.x, least.x, std::max(least.x, most.x)),
                      std::clamp(centre.y, least.y, std::max(least.y, most.y))};
    return {scale, middle - whole.centre() * scale};
}

LiftedShot::LiftedShot(const PlacedShot& placed, std::chrono::nanoseconds now)
    : placed_(placed), from_{.at = placed.placement}, to_{.at = placed.placement} {
    follow(drift_at(placed, now));
    placed_.drift = {};
    if (placed.cell->parts.empty()) return;
    const Polygon& main = placed.cell->parts.front();  // what lies apart from it stays behind
    placed_.cell = std::make_shared<const Cell>(without_filler(inside_part(*placed.cell, {&main, 1})));
}

void LiftedShot::aim(const LiftedPose& to, std::chrono::nanoseconds now, std::chrono::nanoseconds duration) {
    from_ = pose(now);
    to_ = to;
    began_ = now;
    duration_ = duration;
}

void LiftedShot::follow(Vec2 way) {
    from_.at.offset = from_.at.offset + way;
    to_.at.offset = to_.at.offset + way;
}

double LiftedShot::progress(std::chrono::nanoseconds now) const {
    if (now - began_ >= duration_) return 1;
    return std::max(0.0,
                    std::chrono::duration<double>(now - began_) / std::chrono::duration<double>(duration_));
}

LiftedPose LiftedShot::pose(std::chrono::nanoseconds now) const {
    const double share = eased(progress(now));
    return {.at = between(from_.at, to_.at, share),
            .open = from_.open + (to_.open - from_.open) * share,
            .alpha = from_.alpha + (to_.alpha - from_.alpha) * share,
            .dims = from_.dims + (to_.dims - from_.dims) * share};
}

bool LiftedShot::is_at(Vec2 point, std::chrono::nanoseconds now) const {
    PlacedShot placed = placed_;
    placed.cell = drawn(now).cell;
    return vitrine::player::is_at(placed, point);
}

DrawItem LiftedShot::drawn(std::chrono::nanoseconds now) const {
    const LiftedPose at = pose(now);
    DrawItem item{.source = placed_.shot.source,
                  .placement = at.at,
                  .picture = placed_.shot.picture,
                  .active = placed_.shot.active,
                  .local = seen_for(placed_, now),
                  .alpha = at.alpha,
                  .slide_share = 1 - at.open};  // a picture that is seen whole stands still
    const double growth = at.at.scale / placed_.placement.scale;
    Cell carried = scaled_cell(*placed_.cell, growth, at.at.offset - placed_.placement.offset * growth);
    if (at.open > 0 && !carried.parts.empty()) {
        const Polygon whole = transformed(to_polygon(whole_picture(placed_.shot)), at.at.scale, at.at.offset);
        carried = opened(carried.parts[0], whole, centroid(placed_region(placed_.shot.item, at.at)), at.open);
        if (at.open >= 1) carried.parts[0] = whole;
    }
    item.cell = std::make_shared<const Cell>(std::move(carried));
    return item;
}

}  // namespace vitrine::player
