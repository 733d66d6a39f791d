#include "player/scene/crossfade.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine::player {

namespace {

DrawItem drawn(const PlacedShot& placed, double alpha, std::chrono::nanoseconds now) {
    const auto local = std::max(std::chrono::nanoseconds(0), now - placed.began);
    return {.source = placed.shot.source,
            .cell = placed.cell,
            .placement = placed.placement,
            .picture = placed.shot.picture,
            .slide = slide(placed.shot.shot, local),
            .local = local,
            .alpha = alpha};
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

ShotRequest request_of(const PlacedShot& placed) {
    const WallShot& shot = placed.shot;
    const double scale = std::min(1.0, placed.placement.scale);
    return {.source = shot.source,
            .path = shot.key.path,
            .kind = shot.kind,
            .shot = shot.shot,
            .width = std::max(1, static_cast<int>(std::lround(shot.picture.x * scale))),
            .height = std::max(1, static_cast<int>(std::lround(shot.picture.y * scale)))};
}

Vec2 slide(const Shot& shot, std::chrono::nanoseconds local) {
    if (shot.duration().count() <= 0) return {};
    const std::chrono::nanoseconds in_loop = local % shot.duration();
    return shot.region.drift * std::chrono::duration<double>(in_loop).count();
}

double eased(double progress) {
    const double t = std::clamp(progress, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

Frame compose(Vec2 canvas, std::span<const PlacedShot> old_wall, std::span<const PlacedShot> new_wall,
              double progress, std::chrono::nanoseconds now) {
    Frame frame{.canvas = canvas, .time = now};
    const double alpha = eased(progress);
    if (alpha >= 1 || alpha <= 0) {
        const auto wall = alpha >= 1 ? new_wall : old_wall;
        frame.idle = wall.empty() ? 1 : 0;
        draw(frame, wall, 1);
        return frame;
    }
    if (old_wall.empty() || new_wall.empty()) {
        frame.idle = 1;
        draw(frame, old_wall, 1 - alpha);
        draw(frame, new_wall, alpha);
        return frame;
    }
    draw(frame, old_wall, 1);
    for (const PlacedShot& placed : new_wall) {
        if (!is_unchanged(placed, old_wall)) frame.items.push_back(drawn(placed, alpha, now));
    }
    return frame;
}

Frame arriving(Vec2 canvas, std::span<const PlacedShot> wall, std::chrono::nanoseconds crossfade,
               std::chrono::nanoseconds now) {
    Frame frame{.canvas = canvas, .idle = 1, .time = now};
    for (const PlacedShot& placed : wall) {
        if (placed.began == never) continue;
        const double passed = std::chrono::duration<double>(now - placed.began).count();
        const double whole = std::chrono::duration<double>(crossfade).count();
        frame.items.push_back(drawn(placed, passed < whole ? eased(passed / whole) : 1, now));
    }
    return frame;
}

}  // namespace vitrine::player
