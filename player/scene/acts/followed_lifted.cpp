#include "player/scene/acts/followed_lifted.hpp"

#include <utility>

namespace vitrine::player {

namespace {

// With a leader that says no more. A slow one draws, and tells of hands, once a second.
constexpr auto patience = std::chrono::seconds(3);
constexpr auto tapestry_patience = std::chrono::seconds(10);

}  // namespace

void FollowedLifted::set_canvas(Vec2 canvas) {
    if (canvas != canvas_) canvas_before_ = std::exchange(canvas_, canvas);
}

void FollowedLifted::take(LiftedMoment seen, std::optional<TapestryMoment> tapestry,
                          std::chrono::nanoseconds now) {
    seen_ = std::move(seen);
    if (tapestry && tapestry_ && !knows(tapestry->room.canvas)) tapestry->room = tapestry_->room;
    tapestry_ = std::move(tapestry);
    seen_at_ = now;
}

void FollowedLifted::draw(Frame& frame, std::span<const PlacedShot> wall, bool is_film_ready,
                          std::chrono::nanoseconds now) {
    if (now - seen_at_ >= patience) seen_ = {};
    lifted_.show(seen_, wall, frame.time);
    if (!seen_.is_nothing()) lifted_.draw(frame);
    if (seen_.film && is_film_ready) draw_film(frame, *seen_.film);
}

const TapestryMoment* FollowedLifted::tapestry(std::chrono::nanoseconds now) const {
    if (!tapestry_ || now - seen_at_ >= tapestry_patience) return nullptr;
    return knows(tapestry_->room.canvas) ? &*tapestry_ : nullptr;
}

std::map<SourceId, PlacedShot> FollowedLifted::whole_pictures() const {
    std::map<SourceId, PlacedShot> all;
    for (const LiftedMoment::Shot& shot : seen_.shots) {
        const Lifted* const lifted = lifted_.find(shot.source);
        if (lifted == nullptr || shot.full_scale <= 0) continue;
        all[shot.source] = lifted->picture.placed();
        all[shot.source].placement.scale = shot.full_scale;
    }
    return all;
}

}  // namespace vitrine::player
