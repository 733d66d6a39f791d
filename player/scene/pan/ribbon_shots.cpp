#include "player/scene/pan/ribbon_shots.hpp"

#include "player/scene/wall_cells.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vitrine::player {

namespace {

constexpr double ahead = 0.3;   // screens beside the view; the sources of shots up to there are asked for
constexpr double behind = 1.0;  // screens left of the view to which it can go back
constexpr double max_frame_seconds = 0.1;

/// The number of shots on a screen. Few shots are seen once each, or as often as a wide screen has room.
std::size_t shown_a_screen(const PanningShots& shots, Vec2 screen, int most) {
    const auto room = std::clamp(static_cast<int>(screen.x / screen.y), 1, most);
    return std::max(shots.count_shots(static_cast<std::size_t>(most)), static_cast<std::size_t>(room));
}

}  // namespace

RibbonShots::RibbonShots(Vec2 screen, const RibbonSettings& settings)
    : settings_(settings),
      coming_(settings.order, settings.seed, settings.last_source),
      ribbon_{.screen = screen} {}

void RibbonShots::set_screen(Vec2 screen) {
    for (const Shown& shown : shots_)
        if (shown.source != Source::unasked) left_.push_back(shown.placed.shot.source);
    ribbon_ = {.screen = screen};
    shots_.clear();
    extension_.reset();
    newcomers_.clear();
    begin_ = origin_ = 0;
}

void RibbonShots::set_files(const RecordList& records, const ShowHints& hints) {
    coming_.set_files(records, hints);
    for (Shown& shown : shots_) {
        WallShot& shot = shown.placed.shot;
        const RecordList::Record record = records.find(shot.key.path);
        if (!record || static_cast<std::size_t>(shot.key.shot) >= record->shots.size()) continue;
        const std::optional<StoredShot>& stored = shot_now(*record, shot).stored;
        if (stored == shot.shot.stored) continue;
        shot.shot.stored = stored;
        if (shown.source == Source::asked || shown.source == Source::ready)
            restored_.push_back(request_of(shown.placed));
    }
}

bool RibbonShots::is_outdated(double view) const {
    bool is_any = false;
    for (const Shown& shown : shots_) {
        if (!is_in_view(shown, view)) continue;
        if (coming_.has_file(shown.placed.shot.key.path)) return false;
        is_any = true;
    }
    return is_any;
}

RibbonShots RibbonShots::leave() {
    RibbonShots old = *this;
    old.left_.clear();
    old.restored_.clear();
    restored_.clear();
    shots_.clear();  // the old ones keep their sources
    set_screen(ribbon_.screen);
    return old;
}

/// Drops the shots to which the view does not go back any more, and those to come whose files are gone. It
/// does not go back to a shot whose file is gone.
void RibbonShots::drop_passed(double view) {
    const double width = ribbon_.screen.x;
    const auto has_file = [&](const Shown& shown) { return coming_.has_file(shown.placed.shot.key.path); };
    begin_ = std::max(begin_, view - width * behind);
    for (const Shown& shown : shots_)
        if (shown.bounds.max.x <= view && !has_file(shown)) begin_ = std::max(begin_, shown.bounds.max.x);
    for (std::size_t i = shots_.size(); i-- > 0;) {
        const Shown& shown = shots_[i];
        const bool is_gone = !has_file(shown) && shown.bounds.min.x > view + width * (1 + ahead);
        if (shown.bounds.max.x > begin_ && !is_gone) continue;
        if (shown.source != Source::unasked) left_.push_back(shown.placed.shot.source);
        const auto at = static_cast<std::ptrdiff_t>(i);
        shots_.erase(shots_.begin() + at);
        ribbon_.items.erase(ribbon_.items.begin() + at);
        ribbon_.placements.erase(ribbon_.placements.begin() + at);
    }
}

std::optional<WallPlan> RibbonShots::extend(double view) {
    const double width = ribbon_.screen.x;
    if (extension_ || coming_.is_empty()) return std::nullopt;
    if (!ribbon_.items.empty() && view + width < ribbon_.firm - width) return std::nullopt;
    drop_passed(view);
    const auto is_on_wall = [&](const ShotKey& key) {
        return std::ranges::any_of(shots_, [&](const Shown& shown) {
            return shown.bounds.max.x > view && shown.placed.shot.key == key;
        });
    };
    if (newcomers_.empty()) {
        const std::size_t count = shown_a_screen(coming_, ribbon_.screen, settings_.items_a_screen);
        newcomers_ = coming_.next_shots(wanted_newcomers(ribbon_, count), is_on_wall);
    }
    std::vector<LayoutItem> items;
    for (const WallShot& shot : newcomers_)
        items.push_back(shot.item);
    extension_ = extension(ribbon_, items, {});
    return WallPlan{.generation = ++generation_,
                    .canvas = extension_->request.canvas,
                    .items = extension_->request.items};
}

void RibbonShots::set_layout(const Layout& layout) {
    if (!extension_ || layout.generation != generation_ || !layout.is_final) return;
    ribbon_ = extended(ribbon_, *extension_, layout);
    extension_.reset();
    for (const WallShot& shot : newcomers_)
        shots_.push_back({.placed = {.shot = shot, .began = never}});
    newcomers_.clear();
    origin_ = std::floor(begin_);
    std::vector<PlacedShot> wall;
    for (std::size_t i = 0; i < shots_.size(); ++i) {
        shots_[i].placed.placement = ribbon_.placements[i];
        shots_[i].placed.placement.offset.x -= origin_;
        wall.push_back(shots_[i].placed);
    }
    give_cells(wall, {ribbon_.end - origin_, ribbon_.screen.y}, settings_.cells);
    for (std::size_t i = 0; i < shots_.size(); ++i) {
        shots_[i].placed.cell = wall[i].cell;
        shots_[i].bounds = moved(bounds_of(*wall[i].cell), {origin_, 0});
    }
}

void RibbonShots::source_ready(SourceId source) {
    for (Shown& shown : shots_)
        if (shown.placed.shot.source == source && shown.source == Source::asked) shown.source = Source::ready;
}

void RibbonShots::source_failed(SourceId source) {
    for (Shown& shown : shots_)
        if (shown.placed.shot.source == source) shown.source = Source::failed;
}

bool RibbonShots::is_in_view(const Shown& shown, double view) const {
    return shown.bounds.max.x > view && shown.bounds.min.x < view + ribbon_.screen.x;
}

std::vector<PlacedShot> RibbonShots::seen(double view) const {
    std::vector<PlacedShot> seen;
    for (const Shown& shown : shots_)
        if (is_in_view(shown, view) && shown.source == Source::ready) seen.push_back(shown.placed);
    return seen;
}

std::vector<const PlacedShot*> RibbonShots::ready() const {
    std::vector<const PlacedShot*> ready;
    for (const Shown& shown : shots_)
        if (shown.source == Source::ready) ready.push_back(&shown.placed);
    return ready;
}

std::vector<const PlacedShot*> RibbonShots::coming() const {
    std::vector<const PlacedShot*> coming;
    for (const Shown& shown : shots_)
        if (shown.source == Source::ready || shown.source == Source::asked) coming.push_back(&shown.placed);
    return coming;
}

bool RibbonShots::show(double view, double speed, std::chrono::nanoseconds now) {
    for (Shown& shown : shots_) {
        if (!is_in_view(shown, view)) continue;
        if (shown.source == Source::unasked || shown.source == Source::asked) return false;
        if (shown.placed.began != never) continue;
        shown.placed.began = now;
        const double passed = view + ribbon_.screen.x - shown.bounds.min.x;
        if (speed <= 0 || passed > speed * max_frame_seconds) continue;
        shown.placed.began = now - std::chrono::nanoseconds(std::llround(passed / speed * 1e9));
    }
    return true;
}

ViewRange RibbonShots::reach(double view) const {
    const double width = ribbon_.screen.x;
    ViewRange range{.first = begin_, .last = ribbon_.firm - width};
    for (const Shown& shown : shots_) {
        if (shown.source == Source::ready || shown.source == Source::failed) continue;
        if (shown.bounds.max.x <= view)
            range.first = std::max(range.first, shown.bounds.max.x);
        else if (shown.bounds.min.x >= view + width)
            range.last = std::min(range.last, shown.bounds.min.x - width);
    }
    return {.first = std::min(range.first, view), .last = std::max(range.last, view)};
}

void RibbonShots::ask_and_retire(double view, bool goes_back, WallStep& step) {
    const double width = ribbon_.screen.x;
    step.retired.insert(step.retired.end(), left_.begin(), left_.end());
    left_.clear();
    for (ShotRequest& request : std::exchange(restored_, {}))
        step.requests.push_back(std::move(request));
    const double left = view - (goes_back ? width * ahead : 0);
    const double right = view + width * (1 + ahead);
    for (Shown& shown : shots_) {
        const bool is_near = shown.bounds.max.x > left && shown.bounds.min.x < right;
        const bool is_far = shown.bounds.max.x <= left || shown.bounds.min.x >= right + width * ahead;
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

}  // namespace vitrine::player
