#include "player/scene/wall.hpp"

#include "player/scene/crossfade.hpp"
#include "player/scene/photo_drift.hpp"
#include "player/scene/wall_cells.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace vitrine::player {

namespace {

using Phase = WallChange::Phase;

constexpr double worth_replanning = 0.2;  // decrease of the wasted share of the canvas

bool is_same(std::span<const PlacedShot> wall, const std::vector<WallShot>& wanted) {
    return std::equal(wall.begin(), wall.end(), wanted.begin(), wanted.end(),
                      [](const PlacedShot& a, const WallShot& b) { return a.shot.source == b.source; });
}

std::set<SourceId> sources_of(std::span<const PlacedShot> shown, std::span<const PlacedShot> coming,
                              std::span<const WallShot> wanted) {
    std::set<SourceId> sources;
    for (const auto& wall : {shown, coming})
        for (const PlacedShot& placed : wall)
            sources.insert(placed.shot.source);
    for (const WallShot& shot : wanted)
        sources.insert(shot.source);
    return sources;
}

/// A shot that stays keeps its place; a new one takes over the seat of its slot's last shot.
/// Source: Dynamic Media Assemblage, chapter 4: the new shot in the same position.
PlanItem plan_item(const WallShot& shot, std::span<const PlacedShot> shown,
                   const std::map<int, Seat>& left_seats) {
    PlanItem item{.item = shot.item};
    if (const PlacedShot* same = find_source(shown, shot.source))
        item.previous = same->placement;
    else if (const PlacedShot* before = find_slot(shown, shot.slot))
        item.seat = seat_of(before->shot.item, before->placement);
    else if (const auto left = left_seats.find(shot.slot); left != left_seats.end())
        item.seat = left->second;
    return item;
}

/// Where most shots are new, keeping to old places would only leave gaps: the wall is planned anew.
void forget_places_of_few(std::vector<PlanItem>& items) {
    const auto staying =
        std::ranges::count_if(items, [](const PlanItem& item) { return item.previous.has_value(); });
    if (2 * staying >= std::ssize(items)) return;
    for (PlanItem& item : items) {
        item.previous.reset();
        item.seat.reset();
    }
}

/// True if the change can begin without a flash; notes its begin. A calm wall waits with all changes.
bool may_begin(const WallChange& change, std::span<const PlacedShot> shown, ChangePace& pace,
               std::chrono::nanoseconds now) {
    const bool is_small =
        !pace.is_calm() && change.is_by_touch && is_too_small_to_flash(shown, change.wall, change.canvas);
    if (is_small) return true;
    if (!pace.is_free(now)) return false;
    pace.note_change(now);
    return true;
}

/// Starts the time of the shots that have appeared or are about to appear.
void tell_appeared(const WallChange& change, WallSlots& slots) {
    for (const PlacedShot& placed : change.wall)
        if (placed.began != never) slots.shot_appeared(placed.shot.source, placed.began);
}

}  // namespace

int folder_number(const std::string& path, std::map<std::string, int>& folders) {
    const std::size_t slash = path.find('/');
    if (slash == std::string::npos) return PlanItem::no_group;
    return folders.emplace(path.substr(0, slash), static_cast<int>(folders.size())).first->second;
}

Wall::Wall(Vec2 canvas, const WallSettings& settings)
    : settings_(settings),
      canvas_(canvas),
      slots_(settings.slots),
      touch_(settings.touch, settings.idle),
      pace_(settings.is_calm ? calm_spacing : flash_spacing) {}

void Wall::set_canvas(Vec2 canvas) {
    is_canvas_new_ = is_canvas_new_ || canvas != canvas_;
    canvas_ = canvas;
}

void Wall::set_catalogue(const RecordList& records, const ShowHints& hints) {
    const std::vector<WallShot> before = slots_.shots();
    slots_.set_catalogue(records, hints);
    const std::vector<WallShot> known = slots_.shots();
    if (!std::ranges::equal(known, before, {}, &WallShot::source, &WallShot::source))
        touch_.end_enlargement();
    std::vector<ShotRequest> changed = update_stored(shown_, known);
    restored_.insert(restored_.end(), changed.begin(), changed.end());
    if (!change_) return;
    changed = update_stored(change_->wall, known);
    const bool is_asked = change_->phase == Phase::waiting || change_->is_fading();
    if (is_asked) restored_.insert(restored_.end(), changed.begin(), changed.end());
}

void Wall::handle_gesture(const Gesture& gesture) {
    const bool is_drag = gesture.kind == Gesture::Kind::drag;
    if (settings_.nests || (settings_.is_calm && is_drag)) return;
    touch_.handle_gesture(gesture, shown_, canvas_);
}

std::optional<SeenShot> Wall::shot_at(Vec2 point) const {
    const PlacedShot* shot = find_shot_at(shown_, point);
    if (shot == nullptr) return std::nullopt;
    return SeenShot{.source = shot->shot.source, .key = shot->shot.key};
}

void Wall::set_layout(const Layout& layout) {
    if (!change_ || change_->generation != layout.generation || change_->is_fading()) return;
    if (!layout.is_final && !shown_.empty()) return;
    const bool is_fresh = change_->is_replanned() || shown_.empty() || change_->canvas != shown_canvas_;
    lay_out(*change_, layout, settings_.transition.cells);
    const double waste = wasted_share(change_->wall, change_->canvas);
    if (is_fresh) {
        usual_waste_ = waste;
        choose_layout(*change_, worth_replanning);
    } else if (!settings_.nests && waste > usual_waste_ + worth_replanning) {
        reject_layout(*change_);
    }
}

void Wall::source_failed(SourceId source, std::chrono::nanoseconds now) {
    sources_.set_failed(source);
    slots_.source_failed(source, now);
}

std::vector<SlotShot> Wall::standing() const {
    std::vector<SlotShot> all;
    for (const PlacedShot& placed : shown_)
        all.push_back({.slot = placed.shot.slot, .key = placed.shot.key});
    return all;
}

WallStep Wall::step(std::chrono::nanoseconds now) {
    WallStep step{.requests = std::exchange(restored_, {})};
    if (change_ && change_->is_fading()) end_change(now);
    const bool is_touched = touch_.is_active();
    if (is_touched && change_ && !change_->is_fading() && !change_->is_by_touch && !shown_.empty())
        change_.reset();  // the change is planned once nobody touches the wall
    if (!change_ && canvas_ == shown_canvas_) follow_touch(now);
    const bool is_left_alone = !is_touched && !(change_ && change_->is_by_touch);
    if (!change_ && is_left_alone) slots_.advance(now);
    if (!(change_ && change_->is_fading()) && is_left_alone) step.plan = follow_slots();
    if (!step.plan && change_ && change_->phase == Phase::wasteful)
        step.plan = plan_anew(*change_, ++generation_);
    if (change_ && change_->phase == Phase::laid_out) {
        const std::vector<ShotRequest> requests = ask_for_sources(*change_, sources_, now);
        step.requests.insert(step.requests.end(), requests.begin(), requests.end());
    }
    if (change_ && change_->phase == Phase::waiting) wait_for_sources(now);
    step.frame = change_ && change_->is_fading()
                     ? change_frame(*change_, settings_.transition, now)
                     : standing_frame(shown_.empty() ? canvas_ : shown_canvas_, shown_, now);
    step.retired =
        sources_.retire_all_but(sources_of(shown_, change_ ? change_->wall : shown_, slots_.shots()));
    return step;
}

/// Makes the new wall the shown one once its fade has ended.
void Wall::end_change(std::chrono::nanoseconds now) {
    if (change_->phase == Phase::arriving) advance_arrival(now);
    if (!has_ended(*change_, sources_, settings_.transition.duration, now)) return;
    shown_canvas_ = change_->canvas;
    shown_ = std::move(change_->wall);
    change_.reset();
    std::erase_if(left_seats_, [&](const auto& seat) { return find_slot(shown_, seat.first) != nullptr; });
}

/// Starts a small change if a visitor moves, enlarges or dismisses a shot. The next shot of a dismissed
/// shot's slot comes to the place of the dismissed shot.
void Wall::follow_touch(std::chrono::nanoseconds now) {
    std::optional<TouchedWall> next;
    if (std::optional<DismissedShot> dismissed = touch_.take_dismissed(shown_)) {
        left_seats_[dismissed->slot] = dismissed->seat;
        slots_.dismiss_shot(dismissed->source, now);
        if (!dismissed->rest.wall.empty()) next = std::move(dismissed->rest);
    }
    if (!next) next = touch_.next_wall(shown_, canvas_, now);
    if (!next) return;
    change_ = WallChange{.phase = Phase::laid_out,
                         .generation = ++generation_,
                         .canvas = canvas_,
                         .wall = std::move(next->wall),
                         .is_final = true,
                         .is_by_touch = true,
                         .pace = next->pace};
    give_cells(change_->wall, canvas_, settings_.transition.cells);
}

/// Starts a change if the slots hold other shots than those on the wall or on their way to it.
/// @return the plan of the new wall; none: nothing changes, or there is nothing to show
std::optional<WallPlan> Wall::follow_slots() {
    const std::vector<WallShot> wanted = slots_.shots();
    if (is_same(change_ ? change_->wall : shown_, wanted) && !is_canvas_new_) return std::nullopt;
    is_canvas_new_ = false;
    if (!change_ && wanted.empty() && shown_.empty()) return std::nullopt;
    change_ = WallChange{.phase = wanted.empty() ? Phase::laid_out : Phase::planned,
                         .generation = ++generation_,
                         .canvas = canvas_,
                         .is_final = wanted.empty()};
    WallPlan plan{.generation = generation_, .canvas = canvas_};
    std::map<std::string, int> folders;
    for (const WallShot& shot : wanted) {
        const int group = settings_.nests ? folder_number(shot.key.path, folders) : PlanItem::no_group;
        change_->wall.push_back({.shot = shot, .group = group});
        plan.items.push_back(plan_item(shot, shown_, left_seats_));
        plan.items.back().group = group;
    }
    if (plan.items.empty()) return std::nullopt;
    forget_places_of_few(plan.items);
    return plan;
}

/// Starts the fade when everything is ready and the time has come. Gives up on sources that are too late.
void Wall::wait_for_sources(std::chrono::nanoseconds now) {
    if (!is_ready(*change_, sources_, shown_.empty() && !settings_.is_calm)) {
        if (now - *change_->waiting_since >= settings_.patience) give_up_pending(now);
        return;
    }
    TransitionStyle style = transition_style(*change_, settings_.transition);
    const bool is_other_canvas = change_->canvas != shown_canvas_;
    // on the way, hulls of groups might overlap
    style.moves = !is_other_canvas && !settings_.nests && !settings_.is_calm;
    const bool waits_for_turn = !change_->is_by_touch && !is_other_canvas;
    const auto due = waits_for_turn ? slots_.due() : std::nullopt;
    if ((due && now < *due - style.duration) || !may_begin(*change_, shown_, pace_, now)) return;
    if (settings_.photos_drift) give_drifts(change_->wall, shown_);
    if (is_other_canvas && !shown_.empty())
        begin_transition(*change_, fitted(shown_, shown_canvas_, change_->canvas), style, now);
    else
        begin_transition(*change_, shown_, style, now);
    if (change_->phase == Phase::arriving) return advance_arrival(now);
    tell_appeared(*change_, slots_);
}

/// Shows the shots of the first wall whose sources are ready, and gives up on those that are too late.
void Wall::advance_arrival(std::chrono::nanoseconds now) {
    let_arrive(*change_, sources_, now);
    tell_appeared(*change_, slots_);
    if (now - *change_->waiting_since >= settings_.patience) give_up_pending(now);
}

void Wall::give_up_pending(std::chrono::nanoseconds now) {
    for (const SourceId source : sources_.pending(change_->wall))
        source_failed(source, now);
}

}  // namespace vitrine::player
