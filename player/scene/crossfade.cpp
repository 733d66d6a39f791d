#include "player/scene/crossfade.hpp"

#include "player/scene/photo_drift.hpp"
#include "player/scene/wall_cells.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace vitrine::player {

namespace {

DrawItem drawn(const PlacedShot& placed, double alpha, std::chrono::nanoseconds now) {
    return {.source = placed.shot.source,
            .cell = placed.cell,
            .placement = {placed.placement.scale, placed.placement.offset + drift_at(placed, now)},
            .picture = placed.shot.picture,
            .active = placed.shot.active,
            .local = seen_for(placed, now),
            .alpha = placed.is_above ? std::min(alpha, max_blended) : alpha};
}

void draw(Frame& frame, std::span<const PlacedShot> wall, double alpha) {
    for (const PlacedShot& placed : wall)
        frame.items.push_back(drawn(placed, alpha, frame.time));
}

bool is_unchanged(const PlacedShot& placed, std::span<const PlacedShot> old_wall) {
    return std::any_of(old_wall.begin(), old_wall.end(), [&](const PlacedShot& old) {
        return old.shot.source == placed.shot.source && old.placement == placed.placement &&
               (old.cell == placed.cell ||
                (old.cell->parts == placed.cell->parts && old.cell->filler == placed.cell->filler));
    });
}

}  // namespace

double eased(double progress) {
    const double t = std::clamp(progress, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

bool leaves_border(std::span<const PlacedShot> wall, const Box& seen) {
    Box all{seen.max, seen.min};
    for (const PlacedShot& placed : wall) {
        const Box cell = bounds_of(*placed.cell);
        if (!cell.is_empty()) all = united(all, cell);
    }
    return all.min.x > seen.min.x + 1 || all.min.y > seen.min.y + 1 || all.max.x < seen.max.x - 1 ||
           all.max.y < seen.max.y - 1;
}

Frame standing_frame(Vec2 canvas, std::span<const PlacedShot> wall, std::chrono::nanoseconds now, Vec2 view) {
    Frame frame{.canvas = canvas, .view = view, .time = now};
    frame.idle = leaves_border(wall, {view, view + canvas}) ? 1 : 0;
    draw(frame, wall, 1);
    return frame;
}

Frame crossfade(Vec2 canvas, std::span<const PlacedShot> old_wall, std::span<const PlacedShot> new_wall,
                double progress, std::chrono::nanoseconds now) {
    const double alpha = eased(progress);
    if (alpha >= 1 || alpha <= 0) return standing_frame(canvas, alpha >= 1 ? new_wall : old_wall, now);
    Frame frame{.canvas = canvas, .time = now};
    if (old_wall.empty() || new_wall.empty()) {
        frame.idle = 1;
        draw(frame, old_wall, 1 - alpha);
        draw(frame, new_wall, alpha);
        return frame;
    }
    frame.idle = leaves_border(old_wall, {{0, 0}, canvas}) ? 1 : 0;
    draw(frame, old_wall, 1);
    for (const PlacedShot& placed : new_wall) {
        if (!is_unchanged(placed, old_wall)) frame.items.push_back(drawn(placed, alpha, now));
    }
    return frame;
}

Frame fade_in_each(Vec2 canvas, std::span<const PlacedShot> wall, std::chrono::nanoseconds duration,
                   std::chrono::nanoseconds now) {
    Frame frame{.canvas = canvas, .idle = 1, .time = now};
    for (const PlacedShot& placed : wall) {
        if (placed.began == never) continue;
        const double passed = std::chrono::duration<double>(now - placed.began).count();
        const double whole = std::chrono::duration<double>(duration).count();
        frame.items.push_back(drawn(placed, passed < whole ? eased(passed / whole) : 1, now));
    }
    return frame;
}

void fade_in(Frame& frame, const LeavingFrame& before, double progress, double last_part) {
    const double shown = eased(progress);
    for (DrawItem& item : frame.items)
        item.alpha *= shown;
    frame.idle = std::max(before.idle, shown);
    frame.is_fade = true;
    std::vector<DrawItem> items = before.items;
    const double left = (1 - shown) / last_part;
    for (DrawItem& item : items)
        if (left < 1) item.alpha = std::min(item.alpha * left, max_blended);
    items.insert(items.end(), frame.items.begin(), frame.items.end());
    frame.items = std::move(items);
}

}  // namespace vitrine::player
