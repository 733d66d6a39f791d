#include "player/scene/lifted_shots.hpp"

#include "player/scene/crossfade.hpp"

#include <algorithm>

namespace vitrine::player {

namespace {

using State = LiftedState;

constexpr double bright_filler = 0.9;  // share of the picture's brightness, while hands move shots
constexpr auto lighting_time = std::chrono::milliseconds(60);    // before the others make way
constexpr auto darkening_time = std::chrono::milliseconds(200);  // once all stand

constexpr auto beckon_time = std::chrono::milliseconds(600);  // in which the others become dim beside a shot
constexpr double beckon_dims = 0.35;                          // share by which they do

bool is_in_hand(const Lifted& lifted) {
    return lifted.state == State::held || lifted.state == State::large;
}

/// The share to which a shot is away from its place on the wall: large, or flicked out.
double absence(const Lifted& lifted, std::chrono::nanoseconds now) {
    const LiftedPose pose = lifted.picture.pose(now);
    return pose.open > 0 ? pose.open * pose.alpha : 1 - pose.alpha;
}

}  // namespace

double Fading::at(std::chrono::nanoseconds now) const {
    if (now - began >= duration) return to;
    const double share = std::chrono::duration<double>(now - began) / std::chrono::duration<double>(duration);
    return from + (to - from) * eased(share);
}

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

void LiftedShots::beckon(const PlacedShot& placed, std::chrono::nanoseconds now) {
    Lifted* lifted = lift(placed, 0, State::beckoning, now);
    if (lifted != nullptr)
        lifted->picture.aim({.at = placed.placement, .dims = beckon_dims}, now, beckon_time);
}

void LiftedShots::end_beckoning(std::chrono::nanoseconds now) {
    for (auto& [source, lifted] : all_) {
        if (lifted.state != State::beckoning || now - lifted.since < beckon_time) continue;
        const LiftedPose back{.at = lifted.picture.placed().placement};
        if (lifted.picture.goal().dims > 0) lifted.picture.aim(back, now, beckon_time);
    }
    std::erase_if(all_, [&](const auto& entry) {
        return entry.second.state == State::beckoning && now - entry.second.since >= 2 * beckon_time;
    });
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

void LiftedShots::light_filler(std::chrono::nanoseconds now) {
    const bool moves = std::ranges::any_of(all_, [&](const auto& entry) {
        const State state = entry.second.state;
        return state == State::held || state == State::let_go ||
               (state == State::returning && entry.second.picture.pose(now).open <= 0);
    });
    const double wanted = moves ? bright_filler : usual_filler_light;
    if (wanted == filler_light_.to) return;
    filler_light_ = {.from = filler_light_.at(now),
                     .to = wanted,
                     .began = now,
                     .duration = moves ? lighting_time : darkening_time};
}

LiftedMoment LiftedShots::moment(std::chrono::nanoseconds now) const {
    LiftedMoment seen{.shots = {}, .filler_light = filler_light_.at(now)};
    for (const auto& [source, lifted] : all_) {
        const LiftedPose& goal = lifted.picture.goal();
        seen.shots.push_back({.source = source,
                              .state = lifted.state,
                              .pose = lifted.picture.pose(now),
                              .full_scale = goal.open > 0 ? goal.at.scale : 0,
                              .seat = lifted.seat.at(now)});
    }
    return seen;
}

void LiftedShots::show(const LiftedMoment& seen, std::span<const PlacedShot> wall,
                       std::chrono::nanoseconds now) {
    std::erase_if(all_, [&](const auto& entry) {
        return std::ranges::find(seen.shots, entry.first, &LiftedMoment::Shot::source) == seen.shots.end();
    });
    for (const LiftedMoment::Shot& shot : seen.shots) {
        auto place = all_.find(shot.source);
        if (place == all_.end()) {
            const auto placed =
                std::ranges::find(wall, shot.source, [](const PlacedShot& one) { return one.shot.source; });
            if (placed == wall.end() || !placed->cell) continue;
            place = all_.emplace(shot.source, Lifted{.picture = LiftedShot(*placed, now)}).first;
        }
        Lifted& lifted = place->second;
        lifted.state = shot.state;
        lifted.picture.aim(shot.pose, now, std::chrono::nanoseconds(0));
        lifted.seat = {.from = shot.seat, .to = shot.seat};
    }
    filler_light_ = {.from = seen.filler_light, .to = seen.filler_light};
}

/// Lets the idle picture come as a wall of which all shots were flicked out goes: so far they were dim above
/// black.
void LiftedShots::let_idle_come(Frame& frame) const {
    double left = 0;
    for (const DrawItem& item : frame.items) {
        const Lifted* lifted = find(item.source);
        if (lifted == nullptr || lifted->state != State::dismissed) return;
        left = std::max(left, item.alpha);
    }
    frame.idle = std::min(frame.idle, 1 - left);
}

/// Draws the idle picture: hands have all shots, so no cell covers the places that they leave. These places
/// fade out.
void LiftedShots::draw_bare(Frame& frame, double dims) const {
    frame.idle = 1;
    for (DrawItem& item : frame.items) {
        const double seat = find(item.source)->seat.at(frame.time);
        if (seat < 1) item.alpha = std::max(item.alpha, seat * (1 - dims));
    }
}

void LiftedShots::draw(Frame& frame) const {
    std::stable_partition(frame.items.begin(), frame.items.end(),
                          [](const DrawItem& item) { return item.alpha >= 1; });
    let_idle_come(frame);
    double dims = 0;
    for (const auto& [source, lifted] : all_)
        dims = std::max(dims, lifted.picture.pose(frame.time).dims);
    bool is_bare = !frame.items.empty();
    for (DrawItem& item : frame.items) {
        const Lifted* lifted = find(item.source);
        is_bare = is_bare && lifted != nullptr && lifted->state != State::dismissed && item.alpha < 1;
        item.filler_light = filler_light_.at(frame.time);
        const double light = lifted == nullptr ? 1 : 1 - (1 - waiting_light) * absence(*lifted, frame.time);
        if (lifted == nullptr || lifted->state == State::dismissed)
            item.alpha *= std::min(1 - dims, light);
        else if (item.alpha < 1)
            item.alpha *= lifted->seat.at(frame.time) * (1 - dims);
        else
            item.alpha = std::min(1 - dims, light);
    }
    if (is_bare) draw_bare(frame, dims);
    for (const State state : {State::beckoning, State::returning, State::let_go, State::gone, State::large,
                              State::held, State::whole})
        for (const auto& [source, lifted] : all_)
            if (lifted.state == state && lifted.picture.pose(frame.time).alpha > 0)
                frame.items.push_back(lifted.picture.drawn(frame.time));
}

}  // namespace vitrine::player
