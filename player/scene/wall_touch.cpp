#include "player/scene/wall.hpp"

#include <algorithm>
#include <utility>

// What a visitor does to a wall.

namespace vitrine::player {

namespace {

constexpr auto hand_step = std::chrono::milliseconds(120);  // from one step after a finger to the next
constexpr auto dismissal = std::chrono::milliseconds(250);  // that a dismissed shot fades in
constexpr double flight = 0.2;                              // s, that a flicked shot would fly on

}  // namespace

void Wall::handle_gesture(const Gesture& gesture) {
    if (settings_.nests) return;
    const PlacedShot* shot = touched(gesture.from);
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
        return drag_.touch(gesture.at, gesture.from);
    case Gesture::Kind::flick:
        if (const auto held = drag_.held(); leaves(gesture) && (held || shot != nullptr))
            dismissed_ = held ? held->first : shot->shot.source;
        return drag_.lift();
    case Gesture::Kind::drop:
        return drag_.lift();
    default:
        return;
    }
}

/// Whether what is flicked would come out of the canvas.
bool Wall::leaves(const Gesture& flick) const {
    const Vec2 end = flick.at + flick.velocity * flight;
    return end.x < 0 || end.y < 0 || end.x > canvas_.x || end.y > canvas_.y;
}

const PlacedShot* Wall::touched(Vec2 point) const {
    const auto found = std::find_if(shown_.begin(), shown_.end(),
                                    [&](const PlacedShot& placed) { return is_touched(placed, point); });
    return found == shown_.end() ? nullptr : &*found;
}

std::optional<ShotKey> Wall::shot_at(Vec2 point) const {
    const PlacedShot* shot = touched(point);
    if (shot == nullptr) return std::nullopt;
    return shot->shot.key;
}

/// A small change of its own where a finger moves something.
void Wall::follow_hand(std::chrono::nanoseconds now) {
    if (dismissed_ != 0) dismiss(now);
    if (incoming_) return;
    std::optional<std::chrono::nanoseconds> pace;
    auto placements = enlargement_.step(shown_, canvas_, now);
    if (!placements) {
        placements = drag_.step(shown_, canvas_);
        pace = hand_step;
    }
    if (!placements) return;
    std::vector<PlacedShot> wall = shown_;
    for (std::size_t i = 0; i < wall.size(); ++i)
        wall[i].placement = (*placements)[i];
    change_by_hand(std::move(wall), pace);
}

void Wall::change_by_hand(std::vector<PlacedShot> wall, std::optional<std::chrono::nanoseconds> pace) {
    incoming_ = Incoming{.generation = ++generation_,
                         .canvas = canvas_,
                         .wall = std::move(wall),
                         .is_by_hand = true,
                         .pace = pace};
    give_cells(incoming_->wall, canvas_, settings_.transition.cells);
    incoming_->has_layout = incoming_->is_final = incoming_->wants_sources = true;
}

/// What was flicked out fades at once; the next shot of its slot comes to the place that it was taken from.
void Wall::dismiss(std::chrono::nanoseconds now) {
    const SourceId source = std::exchange(dismissed_, 0);
    const auto shot = std::ranges::find(shown_, source, [](const PlacedShot& p) { return p.shot.source; });
    if (shot == shown_.end()) return;
    const auto held = drag_.held();
    left_seats_[shot->shot.slot] =
        seat_of(shot->shot.item, held && held->first == source ? held->second : shot->placement);
    drag_.forget();
    slots_.dismiss_shot(source, now);
    if (shown_.size() < 2) return;
    std::vector<PlacedShot> rest = shown_;
    std::erase_if(rest, [&](const PlacedShot& placed) { return placed.shot.source == source; });
    change_by_hand(std::move(rest), dismissal);
}

}  // namespace vitrine::player
