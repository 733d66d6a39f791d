#include "player/scene/lifted_shots.hpp"

#include <algorithm>

namespace vitrine::player {

namespace {

using State = LiftedState;

bool is_in_hand(const Lifted& lifted) {
    return lifted.state == State::held || lifted.state == State::large;
}

}  // namespace

Lifted* LiftedShots::lift(const PlacedShot& placed, std::uint64_t touch, LiftedState state,
                          std::chrono::nanoseconds now) {
    const auto [place, is_new] =
        all_.try_emplace(placed.shot.source, Lifted{.picture = LiftedShot(placed, now)});
    Lifted& lifted = place->second;
    if (!is_new && is_in_hand(lifted) && lifted.touch != touch) return nullptr;
    if (lifted.state >= State::gone) lifted.picture = LiftedShot(placed, now);
    lifted.state = state;
    lifted.touch = touch;
    lifted.since = now;
    return &lifted;
}

Lifted* LiftedShots::find(SourceId source) {
    const auto found = all_.find(source);
    return found == all_.end() ? nullptr : &found->second;
}

const Lifted* LiftedShots::find(SourceId source) const {
    const auto found = all_.find(source);
    return found == all_.end() ? nullptr : &found->second;
}

Lifted* LiftedShots::of_touch(std::uint64_t touch) {
    const auto found = std::ranges::find_if(
        all_, [&](const auto& entry) { return entry.second.touch == touch && is_in_hand(entry.second); });
    return found == all_.end() ? nullptr : &found->second;
}

bool LiftedShots::is_held() const {
    return std::ranges::any_of(all_, [](const auto& entry) { return is_in_hand(entry.second); });
}

bool LiftedShots::is_active() const {
    return std::ranges::any_of(all_,
                               [](const auto& entry) { return entry.second.state != State::dismissed; });
}

bool LiftedShots::is_away(SourceId source) const {
    const Lifted* lifted = find(source);
    return lifted != nullptr && lifted->state != State::gone;
}

const PlacedShot* LiftedShots::shot_at(Vec2 point, std::chrono::nanoseconds now) const {
    for (const auto& [source, lifted] : all_)
        if (lifted.state < State::gone && lifted.picture.is_at(point, now)) return &lifted.picture.placed();
    return nullptr;
}

void LiftedShots::draw(Frame& frame) const {
    if (all_.empty()) return;
    double dims = 0;
    std::map<SourceId, double> lights;
    for (const auto& [source, lifted] : all_) {
        const double back = lifted.state == State::returning ? lifted.picture.progress(frame.time) : 0;
        const LiftedPose pose = lifted.picture.pose(frame.time);
        const double above = lifted.state < State::gone ? pose.alpha : 1;
        lights[source] = 1 - (1 - waiting_light) * (1 - back) * above;
        dims = std::max(dims, pose.dims);
    }
    for (DrawItem& item : frame.items) {
        const auto light = lights.find(item.source);
        item.alpha *= light == lights.end() ? 1 - dims : std::min(1 - dims, light->second);
    }
    for (const State state :
         {State::returning, State::let_go, State::gone, State::large, State::held, State::whole})
        for (const auto& [source, lifted] : all_)
            if (lifted.state == state && lifted.picture.pose(frame.time).alpha > 0)
                frame.items.push_back(lifted.picture.drawn(frame.time));
}

}  // namespace vitrine::player
