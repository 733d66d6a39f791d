#include "player/scene/folders/folder_wall.hpp"

#include "player/scene/crossfade.hpp"
#include "player/scene/folders/folder_zoom.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <memory>
#include <utility>

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;

constexpr std::size_t max_depth = 64;   // walls that are open behind one another
constexpr auto opening_patience = 12s;  // for the wall of a folder; then it is not opened
constexpr auto source_patience = 3s;    // for one of its sources, and for those of the wall behind
constexpr double mark_from = 0.3;  // share of the way from which on the way back appears on the inner wall
constexpr double mark_time = 0.3;  // share of the way in which it appears

bool is_inside(const Box& box, Vec2 point) {
    return point.x >= box.min.x && point.x <= box.max.x && point.y >= box.min.y && point.y <= box.max.y;
}

template <typename Item> void append(std::vector<Item>& to, const std::vector<Item>& more) {
    to.insert(to.end(), more.begin(), more.end());
}

/// Adds the work of a step to another; the frame stays.
void append_work(WallStep& to, const WallStep& more) {
    append(to.requests, more.requests);
    append(to.retired, more.retired);
}

/// The settings of the wall of an opened folder. Its sources are numbered with those of all others.
WallSettings inner_settings(WallSettings settings) {
    settings.comes_at_once = true;
    settings.patience = source_patience;
    return settings;
}

WallSettings numbered(WallSettings settings) {
    settings.slots.numbers = std::make_shared<SourceId>(settings.slots.last_source);
    return settings;
}

}  // namespace

FolderWall::FolderWall(Vec2 canvas, const WallSettings& settings)
    : settings_(numbered(settings)), canvas_(canvas), wished_depth_(std::numeric_limits<std::size_t>::max()) {
    levels_.emplace_back("", canvas, settings_);
}

void FolderWall::set_canvas(Vec2 canvas) {
    if (canvas == canvas_) return;
    canvas_ = canvas;
    wished_depth_ = 1;
    for (OpenFolder& level : levels_)
        level.wall().set_canvas(canvas);
}

void FolderWall::set_catalogue(const RecordList& records, const ShowHints& hints) {
    records_ = records;
    hints_ = hints;
    for (std::size_t k = 0; k < levels_.size(); ++k) {
        const RecordList inside = records.in_folder(levels_[k].folder());
        if (k > 0 && inside.is_empty()) wished_depth_ = std::min(wished_depth_, k);
        levels_[k].wall().set_catalogue(inside, hints);
    }
}

void FolderWall::set_controls(const ShowControls& controls) {
    controls_ = controls;
    for (OpenFolder& level : levels_)
        level.set_controls(controls);
}

void FolderWall::handle_gesture(const Gesture& gesture) {
    touched_ = now_;
    if (zoom_) return;
    Wall& wall = top().wall();
    const bool is_tap = gesture.kind == Gesture::Kind::tap;
    const bool is_back = gesture.kind == Gesture::Kind::key && gesture.key == Key::back && !wall.is_touched();
    const Box mark = top().way_back();
    const bool is_mark = is_tap && is_inside(mark, gesture.from) && is_inside(mark, gesture.at);
    if (levels_.size() > 1 && (is_back || is_mark)) {
        wished_depth_ = levels_.size() - 1;
        return wall.handle_gesture({.kind = Gesture::Kind::key, .key = Key::back});  // nothing stays large
    }
    if (is_tap) {
        const std::optional<SeenShot> seen = wall.shot_at(gesture.from);
        const SourceId source = gesture.subject != no_subject ? gesture.subject : seen ? seen->source : 0;
        const PlacedShot* shot = find_source(wall.shown(), source);
        if (shot != nullptr && seen && !shot->shot.folder.empty()) {
            wanted_ = shot->shot.folder;
            return;
        }
    }
    wall.handle_gesture(gesture);
}

std::optional<SeenShot> FolderWall::shot_at(Vec2 point) const {
    if (zoom_ || (levels_.size() > 1 && is_inside(top().way_back(), point))) return std::nullopt;
    return top().wall().shot_at(point);
}

void FolderWall::set_layout(const Layout& layout) {
    if (layout.generation != generation_) return;
    Layout inner = layout;
    inner.generation = inner_;
    top().set_layout(inner);
}

void FolderWall::source_ready(SourceId source) {
    for (OpenFolder& level : levels_) {
        level.source_answered(source);
        level.wall().source_ready(source);
    }
}

void FolderWall::source_failed(SourceId source, std::chrono::nanoseconds now) {
    for (OpenFolder& level : levels_) {
        level.source_answered(source);
        level.wall().source_failed(source, level.local(now));
    }
}

WallStep FolderWall::step(std::chrono::nanoseconds now) {
    now_ = now;
    WallStep step;
    if (top().wall().is_touched()) touched_ = now;
    if (levels_.size() > 1 && now - touched_ >= settings_.idle) wished_depth_ = 1;
    const bool is_free = !zoom_ && !top().wall().is_touched();
    if (is_free && levels_.size() > wished_depth_)
        begin_closing(step);
    else if (is_free && !wanted_.empty())
        open(std::exchange(wanted_, {}));
    if (levels_.size() > 1) append_work(step, outer().step(now));
    step_top(step);
    if (zoom_) advance_zoom(step);
    step.frame = composed_frame();
    return step;
}

/// Goes on with the wall on top, which is the only one that asks for plans.
void FolderWall::step_top(WallStep& step) {
    WallStep own = top().step(now_);
    append_work(step, own);
    if (!own.plan) return;
    if (levels_.size() > 1) top().keep_way_back_free(*own.plan);
    inner_ = own.plan->generation;
    own.plan->generation = ++generation_;
    step.plan = std::move(own.plan);
}

void FolderWall::open(const std::string& folder) {
    const RecordList inside = records_.in_folder(folder);
    if (inside.is_empty() || levels_.size() >= max_depth) return;
    top().hold(true);
    levels_.emplace_back(folder, canvas_, inner_settings(settings_));
    top().set_controls(controls_);
    top().wall().set_catalogue(inside, hints_);
    wished_depth_ = levels_.size();
    zoom_ = Zoom{.is_opening = true, .asked = now_, .began = {}, .box = {}};
}

void FolderWall::begin_closing(WallStep& step) {
    if (levels_.size() < 2) return;
    top().hold(true);
    outer().uncover(now_);
    if (levels_.size() > 2) append(step.requests, levels_[levels_.size() - 3].ask_again());
    zoom_ = Zoom{.is_opening = false, .asked = now_, .began = {}, .box = {}};
}

/// Begins the way once both walls can be seen, and ends it.
void FolderWall::advance_zoom(WallStep& step) {
    if (zoom_->began) {
        if (now_ - *zoom_->began >= settings_.transition.duration) end_zoom(step);
        return;
    }
    const bool is_late = now_ - zoom_->asked >= (zoom_->is_opening ? opening_patience : source_patience);
    const bool is_ready =
        zoom_->is_opening ? !top().wall().shown().empty() : outer().has_sources() || is_late;
    if (!is_ready && is_late) {  // the folder has nothing that can be shown
        zoom_->is_opening = false;
        return end_zoom(step);
    }
    ChangePace& pace = *outer().wall().pace();
    const bool is_changing =
        outer().wall().is_changing() || (!zoom_->is_opening && top().wall().is_changing());
    if (!is_ready || is_changing || !pace.is_free(outer().local(now_))) return;
    pace.note_change(outer().local(now_));
    top().wall().pace()->note_change(top().local(now_));
    zoom_->began = now_;
    zoom_->box = box_of_folder(outer().wall().shown(), top().folder(), outer().frame().canvas);
}

/// The wall that is not seen any more goes, or rests.
void FolderWall::end_zoom(WallStep& step) {
    const bool has_opened = std::exchange(zoom_, std::nullopt)->is_opening;
    if (has_opened) {
        outer().cover(now_);
        if (levels_.size() > 2) append(step.retired, levels_[levels_.size() - 3].release_sources());
        return;
    }
    append(step.retired, top().release_sources());
    levels_.pop_back();
    top().uncover(now_);
    top().hold(false);
    if (levels_.size() <= wished_depth_) wished_depth_ = std::numeric_limits<std::size_t>::max();
}

/// The share of the way from the wall behind to the one on top, in [0, 1].
double FolderWall::opened_share() const {
    if (!zoom_) return 1;
    if (!zoom_->began) return zoom_->is_opening ? 0 : 1;
    const double share = std::chrono::duration<double>(now_ - *zoom_->began) /
                         std::chrono::duration<double>(settings_.transition.duration);
    return zoom_->is_opening ? share : 1 - share;
}

Frame FolderWall::composed_frame() const {
    if (levels_.size() < 2) return top().frame();
    const Frame& behind = levels_[levels_.size() - 2].frame();
    const double progress = eased(opened_share());
    const Box box = zoom_ && !settings_.is_calm ? zoom_->box : Box{{0, 0}, behind.canvas};
    Frame frame = zoom_frame(behind, top().frame(), box, progress);
    if (levels_.size() > 2)
        draw_back_mark(frame, levels_[levels_.size() - 2].way_back(), levels_[levels_.size() - 3].frame(),
                       eased(1 - progress / mark_from));
    const Placement at = inner_placement(behind.canvas, box, progress);
    const Box mark = top().way_back();
    draw_back_mark(frame, {mark.min * at.scale + at.offset, mark.max * at.scale + at.offset}, behind,
                   eased((progress - mark_from) / mark_time));
    return frame;
}

}  // namespace vitrine::player
