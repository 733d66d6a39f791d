#include "player/scene/wall_touch.hpp"

#include "base/hints/notice.hpp"
#include "player/scene/crossfade.hpp"
#include "player/scene/photo_drift.hpp"
#include "player/scene/wall_cells.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;
using State = LiftedState;

constexpr auto lift_time = 140ms;     // until a shot under a finger has its size
constexpr auto return_time = 350ms;   // of a shot to its place, and to the whole screen
constexpr auto drag_time = 120ms;     // in which the others make way
constexpr auto home_time = 350ms;     // in which they return
constexpr auto flight_time = 400ms;   // of a flicked shot
constexpr auto offer_time = 4s;       // for which its return is offered
constexpr auto key_time = 24ms;       // between two moments of a way
constexpr double lifted_size = 0.75;  // share of a held shot's scale: it needs less room
constexpr double held_share = 0.62;   // share of the canvas for a shot under a resting finger
constexpr double max_growth = 2.5;    // factor of the scale of a shot that is large in its place
constexpr double softness = 2;        // times the largest scale on the wall, because somebody looks at it
constexpr double flight = 0.2;        // seconds for which a flicked shot would fly on
constexpr double min_way = 4;         // canvas px of a finger that are worth an edit

bool is_inside(Vec2 point, Vec2 canvas) {
    return point.x >= 0 && point.y >= 0 && point.x <= canvas.x && point.y <= canvas.y;
}

Placement scaled_about_point(const Placement& at, Vec2 point, double factor) {
    return {at.scale * factor, point - (point - at.offset) * factor};
}

Placement drifting_placement(const PlacedShot& placed, std::chrono::nanoseconds now) {
    return {placed.placement.scale, placed.placement.offset + drift_at(placed, now)};
}

/// The output that is seen at a place, in the px of shots.
Box output_seen_at(const TouchedWall& wall, Vec2 place) {
    return moved(output_at(wall.canvas, place - wall.origin), wall.origin);
}

/// The scale of a shot that is large in its place, as a factor.
double growth_of(const PlacedShot& placed, const Canvas& canvas) {
    const Box box = bounding_box(placed_region(placed.shot.item, placed.placement));
    const Box seen = output_of(canvas, box);
    return std::clamp(held_share * std::min(seen.width() / box.width(), seen.height() / box.height()), 1.0,
                      max_growth);
}

/// True if a lifted shot is on the wall, or was flicked out and leaves with the change that is seen.
bool is_on(const TouchedWall& wall, SourceId source, const Lifted& lifted) {
    return find_source(wall.shots, source) != nullptr ||
           (wall.is_changing && lifted.state == State::dismissed);
}

bool are_alike(const std::vector<Wish>& a, const std::vector<Wish>& b) {
    return std::ranges::equal(a, b, [](const Wish& one, const Wish& other) {
        return one.item == other.item && one.is_let_go == other.is_let_go && one.at.scale == other.at.scale &&
               length(one.at.offset - other.at.offset) < min_way;
    });
}

}  // namespace

void WallTouch::handle_gesture(const Gesture& gesture, const TouchedWall& wall) {
    using Kind = Gesture::Kind;
    hint_.note_touch(now_);
    SourceId source = gesture.subject;
    if (gesture.touch == 0 && source == no_subject)
        if (const PlacedShot* shot = shot_at(gesture.from, wall)) source = shot->shot.source;
    switch (gesture.kind) {
    case Kind::tap:
        return tap(gesture, source, wall);
    case Kind::hold:
        return hold(gesture, source, wall);
    case Kind::drag:
        return drag(gesture, source, wall);
    case Kind::release:
    case Kind::drop:
    case Kind::flick:
    case Kind::lost:
        return end_drag(gesture, wall);
    case Kind::key:
        if (gesture.key != Key::undo) tapped_ = 0;
        for (auto& [number, lifted] : lifted_.all())
            if (lifted.state == State::gone && gesture.key == Key::undo) bring_back(lifted);
        return;
    default:
        return;
    }
}

/// A shot that was flicked out is touched in its place, to have it back.
void WallTouch::tap(const Gesture& gesture, SourceId source, const TouchedWall& wall) {
    Lifted* lifted = lifted_.find(source);
    if (lifted != nullptr && lifted->state == State::gone) return bring_back(*lifted);
    const bool ends = whole_ != 0 || tapped_ == source || find_source(wall.shots, source) == nullptr;
    tapped_ = ends ? 0 : source;
    tapped_at_ = now_;
    tapped_place_ = gesture.at;
}

/// False: the gesture is for the shot that is as large as the screen, or beside it. Any gesture lets that one
/// return; one of a finger that came down before on another shot is for that shot.
bool WallTouch::is_for_shot(SourceId source) {
    if (whole_ == 0) return true;
    tapped_ = 0;
    return source != no_subject && source != whole_;
}

void WallTouch::drag(const Gesture& gesture, SourceId source, const TouchedWall& wall) {
    if (!is_for_shot(source) || rules_.is_calm) return;
    Lifted* lifted = lifted_.of_touch(gesture.touch);
    if (lifted != nullptr && lifted->state == State::held) return lifted->picture.follow(gesture.moved);
    lifted = lift(source, gesture.touch, State::held, wall);
    if (lifted == nullptr) return;
    if (tapped_ == source) tapped_ = 0;
    const Placement at = lifted->picture.pose(now_).at;
    const double factor = lifted_size * homes_.at(source).scale / at.scale;
    lifted->picture.aim({.at = scaled_about_point(at, gesture.from, factor)}, now_, lift_time);
    lifted->picture.follow(gesture.at - gesture.from);
}

void WallTouch::hold(const Gesture& gesture, SourceId source, const TouchedWall& wall) {
    if (!is_for_shot(source) || rules_.is_calm) return;
    Lifted* lifted = lift(source, gesture.touch, State::large, wall);
    if (lifted == nullptr) return;
    const WallShot& shot = lifted->picture.placed().shot;
    show_large(*lifted, fitting(shot, output_seen_at(wall, gesture.at), held_share, gesture.at), 0);
}

/// Begins to show a whole picture. @param dims  share by which the rest becomes darker
void WallTouch::show_large(Lifted& lifted, const Placement& at, double dims) {
    LiftedPose pose{
        .at = at, .open = 1, .alpha = rules_.is_calm ? 0.0 : 1.0, .dims = rules_.is_calm ? 0 : dims};
    if (rules_.is_calm) lifted.picture.aim(pose, now_, 0ns);
    pose.alpha = 1;
    lifted.picture.aim(pose, now_, return_time);
    PlacedShot large = lifted.picture.placed();
    large.placement = at;
    needs_.requests.push_back(request_of(large));
}

/// Lifts a shot off the wall, or takes it again while it returns. nullptr: it is in another hand, or there is
/// none.
Lifted* WallTouch::lift(SourceId source, std::uint64_t touch, LiftedState state, const TouchedWall& wall) {
    const PlacedShot* placed = find_source(wall.shots, source);
    if (placed == nullptr || !placed->cell) return nullptr;
    Lifted* lifted = lifted_.lift(*placed, touch, state, now_);
    if (lifted == nullptr) return nullptr;
    if (homes_.empty())
        for (const PlacedShot& shot : wall.shots)
            homes_[shot.shot.source] = shot.placement;
    return lifted;
}

void WallTouch::end_drag(const Gesture& gesture, const TouchedWall& wall) {
    Lifted* lifted = lifted_.of_touch(gesture.touch);
    if (lifted == nullptr) return;
    const bool is_dropped = gesture.kind == Gesture::Kind::drop || gesture.kind == Gesture::Kind::flick;
    lifted->since = now_;
    if (lifted->state == State::large || !is_dropped) return bring_back(*lifted);
    const Vec2 end = gesture.at + gesture.velocity * flight;
    const bool is_out = gesture.kind == Gesture::Kind::flick && !is_inside(end, wall.canvas);
    const bool is_notice = notice_named(lifted->picture.placed().shot.key.path).has_value();
    if (is_out && !is_notice) {
        lifted->state = State::gone;
        LiftedPose away = lifted->picture.goal();
        away.at.offset = away.at.offset + gesture.velocity * flight * 2;
        away.alpha = 0;
        return lifted->picture.aim(away, now_, flight_time);
    }
    if (is_out || !is_inside(gesture.at, wall.canvas)) return bring_back(*lifted);
    lifted->state = State::let_go;
}

void WallTouch::bring_back(Lifted& lifted) {
    lifted.state = State::returning;
    lifted.since = now_;
    LiftedPose back{.at = lifted.picture.placed().placement};
    if (rules_.is_calm) {
        back = lifted.picture.goal();
        back.alpha = 0;
    }
    lifted.picture.aim(back, now_, return_time);
}

void WallTouch::put_all_down() {
    lifted_.all().clear();
    homes_.clear();
    asked_.clear();
    above_.clear();
    tapped_ = whole_ = 0;
    needs_.is_whole_over = true;
}

bool WallTouch::advance(std::chrono::nanoseconds now, const TouchedWall& wall, bool may_flash) {
    now_ = now;
    if (tapped_ != 0 && now_ - tapped_at_ >= rules_.idle) tapped_ = 0;
    const auto is_back = [&](const Lifted& lifted) {  // its place on the wall is its own, and is seen
        const SourceId source = lifted.picture.placed().shot.source;
        const auto above = above_.find(source);
        return lifted.state == State::returning && lifted.picture.progress(now_) >= 1 &&
               (above == above_.end() || above->second <= now_) &&
               std::ranges::none_of(asked_, [&](const Wish& wish) {
                   return wish.item < wall.shots.size() && wall.shots[wish.item].shot.source == source;
               });
    };
    for (auto& [source, lifted] : lifted_.all()) {
        const PlacedShot* placed = find_source(wall.shots, source);
        if (placed == nullptr) continue;
        if (lifted.state == State::returning && !rules_.is_calm)
            lifted.picture.move_goal(drifting_placement(*placed, now_));
        if (lifted.state == State::gone && now_ - lifted.since >= offer_time) {
            lifted.state = State::dismissed;
            needs_.dismissed.push_back(source);
        }
        if (is_back(lifted)) needs_.requests.push_back(request_of(*placed));
    }
    std::erase_if(lifted_.all(), [&](const auto& entry) {
        return is_back(entry.second) || !is_on(wall, entry.first, entry.second);
    });
    if (whole_ != 0 && lifted_.find(whole_) == nullptr) {
        whole_ = tapped_ = 0;
        needs_.is_whole_over = true;
    }
    const bool may_beckon = !is_active() && !wall.is_changing && !rules_.is_calm && !wall.shots.empty();
    if (const auto hint = may_beckon ? hint_.next_hint(now_) : std::nullopt)
        lifted_.beckon(wall.shots[*hint % wall.shots.size()], now_);
    lifted_.end_beckoning(now_);
    lifted_.light_filler(now_);
    if (!is_active()) homes_.clear();
    const bool changes = may_flash && (whole_ != 0 ? tapped_ == 0 : tapped_ != 0 && !lifted_.is_held());
    if (changes) change_whole(wall);
    return changes;
}

/// Lets the tapped shot become as large as the screen that was touched, or the large one return.
void WallTouch::change_whole(const TouchedWall& wall) {
    if (whole_ != 0) {
        bring_back(*lifted_.find(std::exchange(whole_, 0)));
        needs_.is_whole_over = true;
        return;
    }
    Lifted* lifted = lift(tapped_, 0, State::whole, wall);
    if (lifted == nullptr) {
        tapped_ = 0;
        return;
    }
    whole_ = tapped_;
    const Box screen = output_seen_at(wall, tapped_place_);
    PlacedShot large = lifted->picture.placed();
    large.placement = fitting(large.shot, screen, 1, screen.centre());
    show_large(*lifted, large.placement, 1 - waiting_light);
    needs_.whole = std::move(large);
}

/// Wishes for shots that fingers drag, then for those that were let go, then for one that is large in its
/// place.
std::vector<Wish> WallTouch::wishes(const TouchedWall& wall) const {
    std::vector<Wish> wishes;
    const auto number_of = [&](const PlacedShot* placed) {
        return static_cast<std::size_t>(placed - wall.shots.data());
    };
    for (const State state : {State::held, State::let_go})
        for (const auto& [source, lifted] : lifted_.all())
            if (const PlacedShot* placed = find_source(wall.shots, source);
                lifted.state == state && placed != nullptr)
                wishes.push_back({.item = number_of(placed),
                                  .at = lifted.picture.goal().at,
                                  .is_in_hand = state == State::held,
                                  .is_let_go = state == State::let_go});
    const PlacedShot* placed = find_source(wall.shots, tapped_);
    const auto home = homes_.find(tapped_);
    if (placed == nullptr || whole_ != 0 || !lifted_.is_held() || home == homes_.end() ||
        lifted_.find(tapped_) != nullptr)
        return wishes;
    PlacedShot at_home = *placed;
    at_home.placement = home->second;
    const Vec2 middle = seat_of(at_home.shot.item, at_home.placement).centre;
    wishes.push_back({.item = number_of(placed),
                      .at = scaled_about_point(at_home.placement, middle, growth_of(at_home, wall.canvas))});
    return wishes;
}

std::optional<TouchedWay> WallTouch::next_way(const TouchedWall& wall) {
    if (homes_.empty()) return std::nullopt;
    std::vector<Wish> wished = wishes(wall);
    if (are_alike(wished, asked_)) return std::nullopt;
    TouchedWay way{.request = {.wall = {.canvas = wall.canvas}, .cells = rules_.cells, .rules = rules_.edits},
                   .duration = wished.empty() || wished.back().is_let_go ? home_time : drag_time};
    std::map<int, LayoutGroup> groups;
    for (const PlacedShot& placed : wall.shots) {
        const auto home = homes_.find(placed.shot.source);
        if (placed.group != PlanItem::no_group)
            groups[placed.group].items.push_back(way.request.wall.items.size());
        way.request.wall.items.push_back(placed.shot.item);
        way.request.wall.placements.push_back(placed.placement);
        way.request.wall.homes.push_back(home == homes_.end() ? placed.placement : home->second);
        way.request.pictures.push_back(placed.shot.picture);
        const Lifted* lifted = lifted_.find(placed.shot.source);
        if (lifted == nullptr) continue;
        const bool is_moved = lifted->state == State::held || lifted->state == State::let_go;
        if (is_moved || (lifted->state == State::returning && placed.is_above))
            way.request.lifted.push_back({way.request.wall.items.size() - 1, !placed.is_above});
    }
    for (auto& [number, group] : groups)
        way.request.groups.push_back(std::move(group));
    way.request.rules.max_scale *= softness;
    way.request.keys = static_cast<std::size_t>(way.duration / key_time);
    takes_ = way.duration;
    way.request.wishes = asked_ = std::move(wished);
    return way;
}

void WallTouch::way_taken(const WallWay& way, const TouchedWall& wall) {
    const WallKey& last = way.keys.back();
    for (std::size_t i = 0; i < wall.shots.size(); ++i) {
        const SourceId source = wall.shots[i].shot.source;
        homes_[source] = way.homes[i];
        const bool is_above = last.alphas[i] < 1;
        Lifted* lifted = lifted_.find(source);
        if (lifted != nullptr && !is_above) lifted->seat = {};
        const auto before = above_.find(source);
        const bool was_held = before != above_.end() && before->second == std::chrono::nanoseconds::max();
        if (lifted != nullptr && is_above && !was_held)
            lifted->seat = {.from = max_blended, .to = 0, .began = now_, .duration = drag_time};
        above_.erase(source);
        if (is_above)
            above_[source] = std::chrono::nanoseconds::max();
        else if (way.keys.front().alphas[i] < 1)
            above_[source] = now_ + takes_ + 2 * key_time;
    }
    for (const Wish& wish : asked_) {
        Lifted* lifted = lifted_.find(wall.shots[wish.item].shot.source);
        if (!wish.is_let_go || lifted == nullptr || lifted->state != State::let_go) continue;
        bring_back(*lifted);
        lifted->picture.move_goal(last.placements[wish.item]);
    }
    std::erase_if(asked_, &Wish::is_let_go);
}

const PlacedShot* WallTouch::shot_at(Vec2 point, const TouchedWall& wall) const {
    if (const PlacedShot* above = lifted_.shot_at(point, now_)) return above;
    if (whole_ != 0) return nullptr;
    for (const PlacedShot& placed : wall.shots)
        if (!lifted_.is_away(placed.shot.source) && is_at(placed, point)) return &placed;
    return nullptr;
}

}  // namespace vitrine::player
