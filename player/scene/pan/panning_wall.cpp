#include "player/scene/pan/panning_wall.hpp"

#include "player/scene/crossfade.hpp"
#include "player/scene/wall_cells.hpp"

#include <algorithm>

namespace vitrine::player {

namespace {

constexpr auto fade_time = std::chrono::milliseconds(800);
constexpr auto patience = std::chrono::seconds(10);  // with sources of the first shots in view

}  // namespace

PanningWall::PanningWall(const Canvas& canvas, const PanSettings& settings)
    : canvas_(canvas),
      shots_(canvas, settings.ribbon),
      motion_(settings.speed),
      touch_({.cells = settings.ribbon.cells, .idle = settings.idle}) {}

void PanningWall::set_canvas(const Canvas& canvas) {
    if (canvas == canvas_) return;
    const Placement place = place_on(canvas_, canvas);
    if (!leaving_)
        leaving_ = Leaving{.shots = shots_.leave(), .view = view_, .place = place, .waiting_since = now_};
    else if (leaving_->fading)
        leaving_->fading = now_ - fade_time;  // it has faded out
    else
        leaving_->place = composed(leaving_->place, place);
    canvas_ = canvas;
    shots_.set_screen(canvas);
    touch_.put_all_down();
    motion_.stop();
    view_ = 0;
}

void PanningWall::set_catalogue(const RecordList& records, const ShowHints& hints) {
    shots_.set_files(records, hints);
    leave_outdated();
}

/// Begins anew if no file in view may be shown any more, but not during such a fade.
void PanningWall::leave_outdated() {
    if (!shots_.is_outdated(view_) || (leaving_ && leaving_->fading)) return;
    if (leaving_)
        shots_.set_screen(canvas_);
    else
        leaving_ = Leaving{.shots = shots_.leave(), .view = view_, .waiting_since = now_};
    touch_.put_all_down();
    motion_.stop();
    view_ = 0;
}

void PanningWall::set_layout(const Layout& layout) {
    if (touch_.is_active()) return shots_.give_up_plan();  // it would move the origin of lifted shots
    shots_.set_layout(layout);
}

void PanningWall::source_failed(SourceId source, std::chrono::nanoseconds /*now*/) {
    shots_.source_failed(source);
}

TouchedWall PanningWall::touched(const std::vector<PlacedShot>& seen) const {
    return {.shots = seen, .canvas = canvas_, .is_changing = true, .origin = {view_ - shots_.origin(), 0}};
}

/// A drag moves the view. It lets go of a shot that was held or enlarged before.
void PanningWall::handle_gesture(const Gesture& gesture) {
    using Kind = Gesture::Kind;
    const std::vector<PlacedShot> seen = shots_.seen(view_);
    const TouchedWall wall = touched(seen);
    Gesture on_ribbon = gesture;
    on_ribbon.at = gesture.at + wall.origin;
    on_ribbon.from = gesture.from + wall.origin;
    motion_.handle_gesture(gesture);
    if (gesture.kind == Kind::drag || gesture.kind == Kind::drop || gesture.kind == Kind::flick) {
        on_ribbon.kind = Kind::release;
        touch_.handle_gesture({.kind = Kind::key, .key = Key::back}, wall);
    }
    touch_.handle_gesture(on_ribbon, wall);
}

std::optional<SeenShot> PanningWall::shot_at(Vec2 point) const {
    const std::vector<PlacedShot> seen = shots_.seen(view_);
    const TouchedWall wall = touched(seen);
    const PlacedShot* shot = touch_.shot_at(point + wall.origin, wall);
    if (shot == nullptr) return std::nullopt;
    return SeenShot{.source = shot->shot.source, .key = shot->shot.key};
}

/// Moves the view, if all shots in it are ready, and up to shots that are not.
void PanningWall::advance(std::chrono::nanoseconds now) {
    now_ = now;
    const double way = motion_.next_way(now);
    const ViewRange reach = shots_.reach(view_);
    const double next = touch_.is_active() ? view_ : std::clamp(view_ + way, reach.first, reach.last);
    is_waiting_ = !shots_.show(next, motion_.own_speed(), now);
    if (!is_waiting_) view_ = next;
}

PanCourse PanningWall::course() const {
    const bool stands = is_waiting_ || touch_.is_active();
    return {.view = view_,
            .since = now_,
            .speed = stands ? 0 : motion_.own_speed(),
            .last = shots_.reach(view_).last};
}

PanParts PanningWall::parts() const {
    return {.shots = shots_.ready(),
            .coming = shots_.coming(),
            .origin = shots_.origin(),
            .course = course(),
            .is_in_hand = motion_.is_in_hand(),
            .has_files = shots_.has_files(),
            .lifted = touch_.lifted()};
}

void PanningWall::follow_touch(std::chrono::nanoseconds now, WallStep& step) {
    const std::vector<PlacedShot> seen = shots_.seen(view_);
    if (touch_.advance(now, touched(seen), pace_.is_free(now))) pace_.note_change(now);
    step.requests = touch_.take_needs().requests;
}

/// Shows the shots that leave until those that come are ready, then fades from one to the other.
void PanningWall::draw_leaving(std::chrono::nanoseconds now, WallStep& step) {
    if (!is_waiting_) leaving_->waiting_since = now;
    const bool is_late = now - leaving_->waiting_since >= patience;
    const std::vector<PlacedShot> coming =
        is_waiting_ && !is_late ? std::vector<PlacedShot>{} : shots_.seen(view_);
    const bool goes = !coming.empty() || (leaving_->shots && !shots_.has_files());
    if (goes && !leaving_->fading && pace_.is_free(now)) {
        leaving_->fading = now;
        pace_.note_change(now);
    }
    const double progress =
        leaving_->fading ? std::chrono::duration<double>(now - *leaving_->fading) / fade_time : 0;
    if (progress >= 1) {
        if (leaving_->shots) {
            leaving_->shots->set_screen(canvas_);
            leaving_->shots->ask_and_retire(0, false, step);
        }
        leaving_.reset();
        return leave_outdated();
    }
    const Vec2 view{view_ - shots_.origin(), 0};
    std::vector<PlacedShot> old;
    if (leaving_->shots) {
        const Vec2 left{leaving_->view - leaving_->shots->origin(), 0};
        const auto [scale, offset] = leaving_->place;
        old = transformed(leaving_->shots->seen(leaving_->view), scale, view + offset - left * scale);
    }
    step.frame = crossfade(canvas_, old, coming, progress, now);
    step.frame.view = view;
    if (!old.empty() && (!coming.empty() || progress <= 0))
        step.frame.idle = leaves_border(old, {view, view + canvas_}) ? 1 : 0;
}

WallStep PanningWall::step(std::chrono::nanoseconds now) {
    WallStep step;
    follow_touch(now, step);
    advance(now);
    if (!touch_.is_active()) step.plan = shots_.extend(view_);
    shots_.ask_and_retire(view_, motion_.may_go_back(now), step);
    step.frame = standing_frame(canvas_, shots_.seen(view_), now, {view_ - shots_.origin(), 0});
    if (is_waiting_) step.frame.idle = 1;
    if (!leaving_ && shots_.seen(view_).empty()) leaving_ = Leaving{.waiting_since = now};
    if (leaving_) draw_leaving(now, step);
    touch_.lifted().draw(step.frame);
    return step;
}

std::vector<SlotShot> PanningWall::standing() const {
    std::vector<SlotShot> all;
    for (const PlacedShot& placed : shots_.seen(view_))
        all.push_back({.slot = static_cast<int>(all.size()), .key = placed.shot.key});
    return all;
}

}  // namespace vitrine::player
