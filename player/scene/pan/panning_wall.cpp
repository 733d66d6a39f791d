#include "player/scene/pan/panning_wall.hpp"

#include "player/scene/crossfade.hpp"
#include "player/scene/wall_cells.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine::player {

namespace {

constexpr double ahead = 0.3;   // screens beside the view; the sources of shots up to there are asked for
constexpr double behind = 1.0;  // screens left of the view to which it can be dragged back

Box bounds_of(const Cell& cell) {
    Box bounds;
    bool any = false;
    for (const std::vector<Polygon>* some : {&cell.parts, &cell.filler})
        for (const Polygon& polygon : *some) {
            bounds = any ? united(bounds, bounding_box(polygon)) : bounding_box(polygon);
            any = true;
        }
    return bounds;
}

}  // namespace

PanningWall::PanningWall(Vec2 canvas, const PanSettings& settings)
    : settings_(settings),
      canvas_(canvas),
      coming_(settings.order, settings.seed, settings.last_source),
      ribbon_{.screen = canvas},
      motion_(settings.speed),
      touch_({.cells = settings.cells, .idle = settings.idle}) {}

void PanningWall::set_canvas(Vec2 canvas) {
    if (canvas == canvas_) return;
    for (const Shown& shown : shots_)
        if (shown.source != Source::unasked) left_.push_back(shown.placed.shot.source);
    canvas_ = canvas;
    ribbon_ = {.screen = canvas};
    shots_.clear();
    extension_.reset();
    touch_.put_all_down();
    motion_.stop();
    begin_ = view_ = base_ = 0;
}

void PanningWall::set_catalogue(const RecordList& records, const ShowHints& hints) {
    coming_.set_files(records, hints);
}

/// Drops the shots that no drag reaches any more, and those to come whose files are gone. The view does not
/// go back to a shot whose file is gone.
void PanningWall::drop_passed() {
    const double right = view_ + canvas_.x * (1 + ahead);
    begin_ = std::max(begin_, view_ - canvas_.x * behind);
    for (const Shown& shown : shots_)
        if (shown.bounds.max.x <= view_ && !coming_.has_file(shown.placed.shot.key.path))
            begin_ = std::max(begin_, shown.bounds.max.x);
    for (std::size_t i = shots_.size(); i-- > 0;) {
        const Shown& shown = shots_[i];
        const bool is_gone = !coming_.has_file(shown.placed.shot.key.path) && shown.bounds.min.x > right;
        if (shown.bounds.max.x > begin_ && !is_gone) continue;
        if (shown.source != Source::unasked) left_.push_back(shown.placed.shot.source);
        const auto at = static_cast<std::ptrdiff_t>(i);
        shots_.erase(shots_.begin() + at);
        ribbon_.items.erase(ribbon_.items.begin() + at);
        ribbon_.placements.erase(ribbon_.placements.begin() + at);
    }
}

bool PanningWall::is_on_wall(const ShotKey& key) const {
    return std::any_of(shots_.begin(), shots_.end(), [&](const Shown& shown) {
        return shown.bounds.max.x > view_ && shown.placed.shot.key == key;
    });
}

std::optional<WallPlan> PanningWall::extend() {
    if (extension_ || coming_.is_empty()) return std::nullopt;
    if (!ribbon_.items.empty() && view_ + canvas_.x < ribbon_.firm - canvas_.x) return std::nullopt;
    drop_passed();
    const std::size_t count = wanted_newcomers(ribbon_, static_cast<std::size_t>(settings_.items_a_screen));
    if (newcomers_.empty())
        newcomers_ = coming_.next_shots(count, [&](const ShotKey& key) { return is_on_wall(key); });
    std::vector<LayoutItem> items;
    for (const WallShot& shot : newcomers_)
        items.push_back(shot.item);
    extension_ = extension(ribbon_, items, {});
    return WallPlan{.generation = ++generation_,
                    .canvas = extension_->request.canvas,
                    .items = extension_->request.items};
}

void PanningWall::set_layout(const Layout& layout) {
    if (!extension_ || layout.generation != generation_ || !layout.is_final) return;
    if (touch_.is_active())
        return extension_.reset();  // it would move the base of lifted shots: asked again later
    ribbon_ = extended(ribbon_, *extension_, layout);
    extension_.reset();
    for (const WallShot& shot : newcomers_)
        shots_.push_back({.placed = {.shot = shot, .began = never}});
    newcomers_.clear();
    base_ = std::floor(begin_);
    std::vector<PlacedShot> wall;
    for (std::size_t i = 0; i < shots_.size(); ++i) {
        shots_[i].placed.placement = ribbon_.placements[i];
        shots_[i].placed.placement.offset.x -= base_;
        wall.push_back(shots_[i].placed);
    }
    give_cells(wall, {ribbon_.end - base_, canvas_.y}, settings_.cells);
    for (std::size_t i = 0; i < shots_.size(); ++i) {
        const Box bounds = bounds_of(*wall[i].cell);
        shots_[i].placed.cell = wall[i].cell;
        shots_[i].bounds = moved(bounds, {base_, 0});
    }
}

void PanningWall::source_ready(SourceId source) {
    for (Shown& shown : shots_)
        if (shown.placed.shot.source == source && shown.source == Source::asked) shown.source = Source::ready;
}

void PanningWall::source_failed(SourceId source, std::chrono::nanoseconds /*now*/) {
    for (Shown& shown : shots_)
        if (shown.placed.shot.source == source) shown.source = Source::failed;
}

bool PanningWall::is_in_view(const Shown& shown) const {
    return shown.bounds.max.x > view_ && shown.bounds.min.x < view_ + canvas_.x;
}

/// The shots that are seen, in px from base_.
std::vector<PlacedShot> PanningWall::seen() const {
    std::vector<PlacedShot> seen;
    for (const Shown& shown : shots_)
        if (is_in_view(shown) && shown.source == Source::ready) seen.push_back(shown.placed);
    return seen;
}

TouchedWall PanningWall::touched(const std::vector<PlacedShot>& seen) const {
    return {.shots = seen, .canvas = canvas_, .origin = {view_ - base_, 0}};
}

/// A drag moves the view. It lets go of a shot that was held or enlarged before.
void PanningWall::handle_gesture(const Gesture& gesture) {
    using Kind = Gesture::Kind;
    const std::vector<PlacedShot> shots = seen();
    const TouchedWall wall = touched(shots);
    Gesture moved = gesture;
    moved.at = moved.at + wall.origin;
    moved.from = moved.from + wall.origin;
    const bool drags =
        gesture.kind == Kind::drag || gesture.kind == Kind::drop || gesture.kind == Kind::flick;
    motion_.handle_gesture(gesture);
    if (drags) {
        moved.kind = Kind::release;
        touch_.handle_gesture({.kind = Kind::key, .key = Key::back}, wall);
    }
    touch_.handle_gesture(moved, wall);
}

std::optional<SeenShot> PanningWall::shot_at(Vec2 point) const {
    const std::vector<PlacedShot> shots = seen();
    const TouchedWall wall = touched(shots);
    const PlacedShot* shot = touch_.shot_at(point + wall.origin, wall);
    if (shot == nullptr) return std::nullopt;
    return SeenShot{.source = shot->shot.source, .key = shot->shot.key};
}

/// Moves the view, if all shots in it are ready, and up to shots that are not.
void PanningWall::advance(std::chrono::nanoseconds now) {
    const double way = motion_.next_way(now);
    double left = begin_;
    double right = std::max(view_, ribbon_.firm - canvas_.x);
    for (Shown& shown : shots_) {
        const bool is_awaited = shown.source == Source::unasked || shown.source == Source::asked;
        if (is_in_view(shown)) {
            if (is_awaited) return;
            if (shown.placed.began == never) shown.placed.began = now;
        } else if (is_awaited && shown.bounds.max.x <= view_) {
            left = std::max(left, shown.bounds.max.x);
        } else if (is_awaited) {
            right = std::min(right, shown.bounds.min.x - canvas_.x);
        }
    }
    if (!touch_.is_active()) view_ = std::clamp(view_ + way, std::min(left, view_), std::max(right, view_));
}

void PanningWall::follow_touch(std::chrono::nanoseconds now, WallStep& step) {
    const std::vector<PlacedShot> shots = seen();
    if (touch_.advance(now, touched(shots), pace_.is_free(now))) pace_.note_change(now);
    step.requests = touch_.take_needs().requests;
}

/// Asks for the sources of shots that come into view soon, and gives those up that are far from it.
void PanningWall::ask_and_retire(std::chrono::nanoseconds now, WallStep& step) {
    step.retired = std::move(left_);
    left_.clear();
    const double left = view_ - (motion_.may_go_back(now) ? canvas_.x * ahead : 0);
    const double right = view_ + canvas_.x * (1 + ahead);
    for (Shown& shown : shots_) {
        const bool is_near = shown.bounds.max.x > left && shown.bounds.min.x < right;
        const bool is_far = shown.bounds.max.x <= left || shown.bounds.min.x >= right + canvas_.x * ahead;
        if (shown.source == Source::unasked && is_near) {
            step.requests.push_back(request_of(shown.placed));
            shown.source = Source::asked;
        } else if (shown.source != Source::unasked && is_far) {
            step.retired.push_back(shown.placed.shot.source);
            shown.placed.shot.source = coming_.next_source();
            shown.placed.began = never;
            shown.source = Source::unasked;
        }
    }
}

WallStep PanningWall::step(std::chrono::nanoseconds now) {
    WallStep step;
    follow_touch(now, step);
    advance(now);
    if (!touch_.is_active()) step.plan = extend();
    ask_and_retire(now, step);
    step.frame = standing_frame(canvas_, seen(), now);
    step.frame.view = {view_ - base_, 0};
    touch_.draw(step.frame);
    return step;
}

std::vector<SlotShot> PanningWall::standing() const {
    std::vector<SlotShot> all;
    for (const Shown& shown : shots_)
        if (is_in_view(shown) && shown.source == Source::ready)
            all.push_back({.slot = static_cast<int>(all.size()), .key = shown.placed.shot.key});
    return all;
}

}  // namespace vitrine::player
