#include "player/scene/pan/panning_wall.hpp"

#include "player/scene/crossfade.hpp"
#include "player/scene/wall_cells.hpp"

#include <algorithm>
#include <cmath>

namespace vitrine::player {

namespace {

constexpr double ahead = 0.3;  // screens right of the view; the sources of shots up to there are asked for
constexpr auto max_step = std::chrono::milliseconds(100);  // longer pauses are not made up for

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
      ribbon_{.screen = canvas} {}

void PanningWall::set_canvas(const Canvas& canvas) {
    if (Vec2(canvas) == canvas_) return;
    for (const Shown& shown : shots_)
        if (shown.source != Source::unasked && shown.source != Source::retired)
            left_.push_back(shown.placed.shot.source);
    canvas_ = canvas;
    ribbon_ = {.screen = canvas};
    shots_.clear();
    extension_.reset();
    view_ = base_ = 0;
}

void PanningWall::set_catalogue(const RecordList& records, const ShowHints& hints) {
    coming_.set_files(records, hints);
}

/// Drops the shots that have left the view, and those to come whose files are gone.
void PanningWall::drop_passed() {
    const double right = view_ + canvas_.x * (1 + ahead);
    for (std::size_t i = shots_.size(); i-- > 0;) {
        const Shown& shown = shots_[i];
        const bool is_gone = !coming_.has_file(shown.placed.shot.key.path) && shown.bounds.min.x > right &&
                             shown.source == Source::unasked;
        if (shown.source != Source::retired && !is_gone) continue;
        const auto at = static_cast<std::ptrdiff_t>(i);
        shots_.erase(shots_.begin() + at);
        ribbon_.items.erase(ribbon_.items.begin() + at);
        ribbon_.placements.erase(ribbon_.placements.begin() + at);
    }
}

bool PanningWall::is_on_wall(const ShotKey& key) const {
    return std::any_of(shots_.begin(), shots_.end(), [&](const Shown& shown) {
        return shown.source != Source::retired && shown.placed.shot.key == key;
    });
}

std::optional<WallPlan> PanningWall::extend() {
    if (extension_ || coming_.is_empty()) return std::nullopt;
    if (!ribbon_.items.empty() && view_ + canvas_.x < ribbon_.firm - canvas_.x) return std::nullopt;
    drop_passed();
    const std::size_t count = wanted_newcomers(ribbon_, static_cast<std::size_t>(settings_.items_a_screen));
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
    ribbon_ = extended(ribbon_, *extension_, layout);
    extension_.reset();
    for (const WallShot& shot : newcomers_)
        shots_.push_back({.placed = {.shot = shot, .began = never}});
    base_ = std::floor(view_);
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

/// Moves the view, if all shots in it are ready.
void PanningWall::advance(std::chrono::nanoseconds now) {
    const std::chrono::nanoseconds passed =
        std::min<std::chrono::nanoseconds>(now - last_.value_or(now), max_step);
    last_ = now;
    for (Shown& shown : shots_) {
        if (!is_in_view(shown)) continue;
        if (shown.source == Source::unasked || shown.source == Source::asked) return;
        if (shown.placed.began == never) shown.placed.began = now;
    }
    if (is_paused_) return;
    const double step = settings_.speed * std::chrono::duration<double>(passed).count();
    view_ = std::min(view_ + step, std::max(view_, ribbon_.firm - canvas_.x));
}

void PanningWall::ask_and_retire(WallStep& step) {
    step.retired = std::move(left_);
    left_.clear();
    for (Shown& shown : shots_) {
        if (shown.source == Source::unasked && shown.bounds.min.x < view_ + canvas_.x * (1 + ahead)) {
            step.requests.push_back(request_of(shown.placed));
            shown.source = Source::asked;
        }
        if (shown.bounds.max.x > view_ || shown.source == Source::retired) continue;
        if (shown.source != Source::unasked) step.retired.push_back(shown.placed.shot.source);
        shown.source = Source::retired;
    }
}

WallStep PanningWall::step(std::chrono::nanoseconds now) {
    WallStep step;
    advance(now);
    step.plan = extend();
    ask_and_retire(step);
    std::vector<PlacedShot> seen;
    for (const Shown& shown : shots_)
        if (is_in_view(shown) && shown.source == Source::ready) seen.push_back(shown.placed);
    step.frame = standing_frame(canvas_, seen, now);
    step.frame.view = {view_ - base_, 0};
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
