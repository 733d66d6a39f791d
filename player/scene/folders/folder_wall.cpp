#include "player/scene/folders/folder_wall.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace vitrine::player {

namespace {

constexpr std::size_t max_depth = 64;  // walls that are open behind one another

bool is_inside(const Box& box, Vec2 point) {
    return point.x >= box.min.x && point.x < box.max.x && point.y >= box.min.y && point.y < box.max.y;
}

}  // namespace

FolderWall::FolderWall(const Canvas& canvas, const WallSettings& settings)
    : idle_(settings.idle), canvas_(canvas), folders_(canvas, settings), wished_depth_(max_depth) {}

void FolderWall::set_canvas(const Canvas& canvas) {
    if (canvas == canvas_ && canvas.finger == canvas_.finger) return;
    canvas_ = canvas;
    wished_depth_ = 1;
    folders_.set_canvas(canvas);
}

void FolderWall::set_catalogue(const RecordList& records, const ShowHints& hints) {
    records_ = records;
    hints_ = hints;
    for (std::size_t k = 0; k < folders_.depth(); ++k) {
        OpenFolder& level = folders_.levels()[k];
        const RecordList inside = records.in_folder(level.folder());
        if (k > 0 && inside.is_empty()) wished_depth_ = std::min(wished_depth_, k);
        level.wall().set_catalogue(inside, hints);
    }
}

void FolderWall::set_controls(const ShowControls& controls) {
    if (controls.arranged && controls.arranged != arranged_) wished_depth_ = 1;
    arranged_ = controls.arranged;
    controls_ = controls;
    controls_.arranged.reset();
    folders_.levels().front().set_controls(controls);
    for (std::size_t k = 1; k < folders_.depth(); ++k)
        folders_.levels()[k].set_controls(controls_);
}

void FolderWall::handle_gesture(const Gesture& gesture) {
    touched_ = now_;
    if (folders_.is_on_way()) return;
    const bool is_tap = gesture.kind == Gesture::Kind::tap;
    const bool is_back =
        gesture.kind == Gesture::Kind::key && gesture.key == Key::back && !wall().is_touched();
    const bool is_mark = is_tap && is_inside(way_back(), gesture.from) && is_inside(way_back(), gesture.at);
    if (is_mark || (is_back && folders_.depth() > 1)) {
        wished_depth_ = folders_.depth() - 1;
        return wall().handle_gesture({.kind = Gesture::Kind::key, .key = Key::back});  // nothing stays large
    }
    const std::optional<SeenShot> seen = is_tap ? wall().shot_at(gesture.from) : std::nullopt;
    const SourceId source = gesture.subject != no_subject ? gesture.subject : seen ? seen->source : 0;
    const PlacedShot* shot = seen ? find_source(wall().shown(), source) : nullptr;
    if (shot != nullptr && !shot->shot.folder.empty())
        wanted_ = shot->shot.folder;
    else
        wall().handle_gesture(gesture);
}

std::optional<SeenShot> FolderWall::shot_at(Vec2 point) const {
    const bool is_opening = !wanted_.empty() || folders_.is_on_way();
    if (is_opening || is_inside(way_back(), point)) return std::nullopt;
    return wall().shot_at(point);
}

void FolderWall::set_layout(const Layout& layout) {
    folders_.set_layout(layout);
}

void FolderWall::source_ready(SourceId source) {
    for (OpenFolder& level : folders_.levels()) {
        level.source_answered(source);
        level.wall().source_ready(source);
    }
}

void FolderWall::source_failed(SourceId source, std::chrono::nanoseconds now) {
    for (OpenFolder& level : folders_.levels()) {
        level.source_answered(source);
        level.wall().source_failed(source, level.local(now));
    }
}

WallStep FolderWall::step(std::chrono::nanoseconds now) {
    now_ = now;
    if (wall().is_touched()) touched_ = now;
    if (now - touched_ >= idle_) wished_depth_ = 1;
    if (folders_.depth() <= std::min(wished_depth_, max_depth) && !folders_.is_on_way())
        wished_depth_ = max_depth;
    if (!folders_.is_on_way() && !wall().is_touched()) {
        const RecordList inside = wanted_.empty() ? RecordList() : records_.in_folder(wanted_);
        if (folders_.depth() > wished_depth_)
            folders_.close();
        else if (!inside.is_empty() && folders_.depth() < max_depth)
            folders_.open(wanted_, inside, hints_, controls_);
        wanted_.clear();
    }
    return folders_.step(now);
}

}  // namespace vitrine::player
