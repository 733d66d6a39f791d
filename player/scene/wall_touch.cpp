#include "player/scene/wall_touch.hpp"

#include "player/layout/plan/plan_request.hpp"
#include "player/scene/wall_cells.hpp"

#include <utility>

namespace vitrine::player {

namespace {

constexpr auto drag_step = std::chrono::milliseconds(120);       // between two steps towards a finger
constexpr auto dismissal_fade = std::chrono::milliseconds(250);  // fade of a dismissed shot
constexpr double flight = 0.2;  // seconds for which a flicked shot would fly on

/// True if a flicked shot would leave the canvas.
bool leaves(const Gesture& flick, Vec2 canvas) {
    const Vec2 end = flick.at + flick.velocity * flight;
    return end.x < 0 || end.y < 0 || end.x > canvas.x || end.y > canvas.y;
}

}  // namespace

void WallTouch::handle_gesture(const Gesture& gesture, std::span<const PlacedShot> wall, Vec2 canvas) {
    const PlacedShot* shot = find_shot_at(wall, gesture.from);
    switch (gesture.kind) {
    case Gesture::Kind::tap:
        return shot != nullptr ? enlargement_.toggle(shot->shot.source) : enlargement_.end();
    case Gesture::Kind::hold:
        return shot != nullptr ? enlargement_.hold(shot->shot.source) : enlargement_.end();
    case Gesture::Kind::release:
    case Gesture::Kind::key:
        return enlargement_.end();
    case Gesture::Kind::drag:
        enlargement_.end();
        return drag_.follow_finger(gesture.at, gesture.from);
    case Gesture::Kind::flick:
        if (const auto held = drag_.held(); leaves(gesture, canvas) && (held || shot != nullptr))
            dismissed_ = held ? held->source : shot->shot.source;
        return drag_.lift_finger();
    case Gesture::Kind::drop:
        return drag_.lift_finger();
    default:
        return;
    }
}

std::optional<DismissedShot> WallTouch::take_dismissed(std::span<const PlacedShot> wall) {
    const SourceId source = std::exchange(dismissed_, 0);
    const PlacedShot* shot = find_source(wall, source);
    if (shot == nullptr) return std::nullopt;
    const auto held = drag_.held();
    const Placement from = held && held->source == source ? held->home : shot->placement;
    drag_.let_go();
    DismissedShot dismissed{.source = source,
                            .slot = shot->shot.slot,
                            .seat = seat_of(shot->shot.item, from),
                            .rest = {.wall = {wall.begin(), wall.end()}, .pace = dismissal_fade}};
    std::erase_if(dismissed.rest.wall,
                  [&](const PlacedShot& placed) { return placed.shot.source == source; });
    return dismissed;
}

std::optional<TouchedWall> WallTouch::next_wall(std::span<const PlacedShot> wall, Vec2 canvas,
                                                std::chrono::nanoseconds now) {
    TouchedWall next{.wall = {wall.begin(), wall.end()}, .pace = {}};
    auto placements = enlargement_.next_placements(wall, canvas, now);
    if (!placements) {
        placements = drag_.next_placements(wall, canvas);
        next.pace = drag_step;
    }
    if (!placements) return std::nullopt;
    for (std::size_t i = 0; i < next.wall.size(); ++i)
        next.wall[i].placement = (*placements)[i];
    return next;
}

}  // namespace vitrine::player
