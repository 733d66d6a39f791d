#include "player/scene/wall.hpp"

#include "base/hints/notice.hpp"
#include "player/scene/caption_place.hpp"
#include "player/scene/crossfade.hpp"
#include "player/scene/photo_drift.hpp"
#include "player/scene/wall_cells.hpp"

#include <algorithm>
#include <initializer_list>
#include <memory>
#include <set>
#include <utility>

namespace vitrine::player {

namespace {

using Phase = WallChange::Phase;

constexpr std::chrono::nanoseconds max_notice_motion = std::chrono::milliseconds(250);  // a notice is urgent
constexpr std::chrono::nanoseconds max_notice_lead = std::chrono::milliseconds(500);
constexpr int dark_patience = 6;          // times the patience, as long as there is nothing to show
constexpr double worth_replanning = 0.2;  // decrease of the wasted share of the canvas

bool is_same(std::span<const PlacedShot> wall, const std::vector<WallShot>& wanted) {
    return std::equal(wall.begin(), wall.end(), wanted.begin(), wanted.end(),
                      [](const PlacedShot& a, const WallShot& b) { return a.shot.source == b.source; });
}

/// The sources of all walls that are seen or come, and of the shots that are wanted.
std::set<SourceId> sources_of(std::initializer_list<std::span<const PlacedShot>> walls,
                              std::span<const WallShot> wanted) {
    std::set<SourceId> sources;
    for (const auto& wall : walls)
        for (const PlacedShot& placed : wall)
            sources.insert(placed.shot.source);
    for (const WallShot& shot : wanted)
        sources.insert(shot.source);
    return sources;
}

/// True: a notice comes, or its next shot.
bool brings_notice(const WallChange& change) {
    return std::ranges::any_of(
        change.wall, [](const PlacedShot& placed) { return notice_named(placed.shot.key.path).has_value(); });
}

bool is_in(std::span<const WallShot> wanted, SourceId source) {
    return std::ranges::find(wanted, source, &WallShot::source) != wanted.end();
}

/// The seat of all these shots together: the middle of their I-Regions, and the sum of the areas.
std::optional<Seat> common_seat(std::span<const PlacedShot* const> shots) {
    if (shots.empty()) return std::nullopt;
    Seat all;
    for (const PlacedShot* placed : shots) {
        const Seat seat = seat_of(placed->shot.item, placed->placement);
        all.centre = all.centre + seat.centre * seat.area;
        all.area += seat.area;
    }
    all.centre = all.centre * (1 / all.area);
    return all;
}

/// The items of the new wall. A shot that stays keeps its place. In a slot that holds another entry, all
/// shots take over the seat of the last one; in a folder that stays, a new shot takes over that of one that
/// leaves. Source: Dynamic Media Assemblage, chapter 4: the new shot in the same position.
std::vector<PlanItem> plan_items(std::span<const WallShot> wanted, std::span<const PlacedShot> shown) {
    std::map<int, std::vector<const PlacedShot*>> leaving;  // by slot
    std::set<int> staying;                                  // slots
    for (const PlacedShot& placed : shown) {
        if (is_in(wanted, placed.shot.source))
            staying.insert(placed.shot.slot);
        else
            leaving[placed.shot.slot].push_back(&placed);
    }
    std::map<int, std::size_t> used;  // of those that leave, by slot
    std::vector<PlanItem> items;
    for (const WallShot& shot : wanted) {
        PlanItem& item = items.emplace_back(PlanItem{
            .item = shot.item, .look = shot.shot.look, .taken = shot.taken, .group = group_of(shot)});
        const std::vector<const PlacedShot*>& left = leaving[shot.slot];
        if (const PlacedShot* same = find_source(shown, shot.source))
            item.previous = same->placement;
        else if (!staying.contains(shot.slot))
            item.seat = common_seat(left);
        else if (const std::size_t next = used[shot.slot]++; next < left.size())
            item.seat = seat_of(left[next]->shot.item, left[next]->placement);
    }
    return items;
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

/// True if a change can begin without a flash; notes its begin.
bool may_begin(ChangePace& pace, std::chrono::nanoseconds now) {
    if (!pace.is_free(now)) return false;
    pace.note_change(now);
    return true;
}

/// The wall that a finger touches: that which comes, if it is on its way.
TouchedWall touched_wall(const std::optional<WallChange>& change, std::span<const PlacedShot> shown,
                         const Canvas& canvas) {
    const bool is_coming = change && change->phase == Phase::fading;
    return {.shots = is_coming ? std::span<const PlacedShot>(change->wall) : shown,
            .canvas = canvas,
            .is_changing = change.has_value()};
}

/// Starts the time of the shots that have appeared or are about to appear.
void tell_appeared(const WallChange& change, WallEntries& slots) {
    for (const PlacedShot& placed : change.wall)
        if (placed.began != never) slots.shot_appeared(placed.shot.source, placed.began);
}

/// Calls source_failed() of the wall for all sources of a change that are neither ready nor failed.
void give_up_pending(const WallChange& change, const WallSources& sources, Wall& wall,
                     std::chrono::nanoseconds now) {
    for (const SourceId source : sources.pending(change.wall))
        wall.source_failed(source, now);
}

/// The time after which late sources are given up. It is longer as long as nothing at all can be shown: a
/// file that is given up is avoided for a minute, and a slow box would show nothing for ever.
std::chrono::nanoseconds patience_for(const WallChange& change, std::span<const PlacedShot> shown,
                                      const WallSources& sources, std::chrono::nanoseconds patience) {
    const auto is_ready = [&](const PlacedShot& placed) { return sources.is_ready(placed); };
    const bool is_dark = shown.empty() && std::ranges::none_of(change.wall, is_ready);
    return is_dark ? dark_patience * patience : patience;
}

/// Shows the shots of the first wall whose sources are ready.
void show_arrived(WallChange& change, const WallSources& sources, WallEntries& slots,
                  std::chrono::nanoseconds now) {
    let_arrive(change, sources, now);
    tell_appeared(change, slots);
}

/// True once a change is drawn. One to another canvas is drawn from its begin on, as outputs show other parts
/// of that canvas.
bool is_drawn(const WallChange& change, std::span<const PlacedShot> shown, Vec2 shown_canvas,
              std::chrono::nanoseconds now) {
    if (!change.is_fading()) return false;
    return change.began <= now || change.canvas == shown_canvas || shown.empty();
}

WallSettings with_numbers(WallSettings settings) {
    std::shared_ptr<SourceId>& numbers = settings.slots.numbers;
    if (!numbers) numbers = std::make_shared<SourceId>(settings.slots.last_source);
    return settings;
}

}  // namespace

Wall::Wall(const Canvas& canvas, const WallSettings& settings)
    : settings_(with_numbers(settings)),
      canvas_(canvas),
      slots_(settings_.slots, settings.nests),
      copies_(settings_.slots.numbers),
      touch_({.edits = settings.touch,
              .cells = settings.transition.cells,
              .idle = settings.idle,
              .hint = settings.hint,
              .is_calm = settings.is_calm}),
      pace_(settings.is_calm ? calm_spacing : flash_spacing) {}

void Wall::set_canvas(const Canvas& canvas) {
    if (canvas == canvas_) {
        canvas_ = canvas;
        return;
    }
    must_plan_ = true;
    canvas_ = canvas;
    touch_.put_all_down();
    if (change_ && change_->is_by_touch) change_.reset();
    if (std::ranges::none_of(shown_, &PlacedShot::is_above)) return;
    for (PlacedShot& placed : shown_)
        placed.is_above = false;
    give_cells(shown_, shown_canvas_, settings_.transition.cells);
}

void Wall::set_catalogue(const RecordList& records, const ShowHints& hints) {
    const std::size_t displays = count_surfaces(canvas_);
    const std::vector<WallShot> before = copies_.with_copies(slots_.shots(), displays);
    slots_.set_catalogue(records, hints);
    const std::vector<WallShot> known = copies_.with_copies(slots_.shots(), displays);
    if (!std::ranges::equal(known, before, {}, &WallShot::source, &WallShot::source))
        touch_.handle_gesture({.kind = Gesture::Kind::key, .key = Key::back}, {});
    sources_.request_again(update_stored(shown_, known));
    if (!change_) return;
    const std::vector<ShotRequest> changed = update_stored(change_->wall, known);
    const bool is_asked = change_->phase == Phase::waiting || change_->is_fading();
    if (is_asked) sources_.request_again(changed);
}

void Wall::handle_gesture(const Gesture& gesture) {
    touch_.handle_gesture(gesture, touched_wall(change_, shown_, canvas_));
}

std::optional<SeenShot> Wall::shot_at(Vec2 point) const {
    const PlacedShot* shot = touch_.shot_at(point, touched_wall(change_, shown_, canvas_));
    if (shot == nullptr) return std::nullopt;
    return SeenShot{.source = shot->shot.source, .key = shot->shot.key};
}

void Wall::set_layout(const Layout& layout) {
    if (!change_ || change_->generation != layout.generation || change_->is_fading()) return;
    if (layout.way) {
        touch_.way_taken(*layout.way, take_way(*change_, layout.way));
        return;
    }
    if (!layout.is_final && !shown_.empty()) return;
    const bool is_fresh = change_->is_replanned() || shown_.empty() || change_->canvas != shown_canvas_;
    lay_out(*change_, layout, settings_.transition.cells);
    const double waste = wasted_share(change_->wall, change_->canvas);
    if (is_fresh || change_->is_arranged) {
        usual_waste_ = waste;
        choose_layout(*change_, worth_replanning);
    } else if (waste > usual_waste_ + worth_replanning) {
        reject_layout(*change_);
    }
}

void Wall::source_failed(SourceId source, std::chrono::nanoseconds now) {
    sources_.set_failed(source);
    touched_film_.source_failed(source);
    slots_.source_failed(copies_.original_of(source), now);
}

void Wall::set_controls(const ShowControls& controls) {
    is_held_ = controls.is_held;
    const ArrangedWall* const awaited = slots_.arranged();
    slots_.set_controls(controls);
    if (slots_.arranged() == awaited) return;
    must_plan_ = true;
    touch_.handle_gesture({.kind = Gesture::Kind::key, .key = Key::back}, {});
}

std::vector<SlotShot> Wall::standing() const {
    std::vector<SlotShot> all;
    for (const PlacedShot& placed : shown_)
        all.push_back({.slot = placed.shot.slot,
                       .key = placed.shot.key,
                       .folder = placed.shot.folder,
                       .at = placed.placement,
                       .seat = seat_of(placed.shot.item, placed.placement)});
    return all;
}

WallStep Wall::step(std::chrono::nanoseconds now) {
    WallStep step{.requests = sources_.take_requests()};
    if (change_ && change_->is_fading()) end_change(now);
    const bool is_touched = touch_.is_active() || is_held_;
    if (is_touched && change_ && !change_->is_fading() && !change_->is_by_touch && !shown_.empty())
        change_.reset();  // the change is planned once nobody touches the wall
    follow_touch(now, step);
    const bool is_left_alone = !is_touched && !(change_ && change_->is_by_touch);
    if (!change_ && is_left_alone) {
        slots_.advance(now);
        copies_.advance(now);
    }
    if (!(change_ && change_->is_fading()) && is_left_alone) step.plan = follow_slots();
    if (change_ && change_->way && !change_->is_fading())
        begin_way(*change_, shown_, settings_.photos_drift && change_->drifts_after,
                  now + settings_.touch_lead);
    if (!step.plan && change_ && change_->phase == Phase::wasteful)
        step.plan = plan_anew(*change_, ++generation_);
    if (change_ && change_->phase == Phase::laid_out) {
        const std::vector<ShotRequest> requests = ask_for_sources(*change_, sources_, now);
        step.requests.insert(step.requests.end(), requests.begin(), requests.end());
    }
    if (change_ && change_->phase == Phase::waiting) wait_for_sources(now);
    step.frame = change_ && is_drawn(*change_, shown_, shown_canvas_, now)
                     ? change_frame(*change_, shown_, settings_.transition, now)
                     : standing_frame(shown_.empty() ? canvas_ : shown_canvas_, shown_, now);
    touch_.lifted().draw(step.frame);
    if (touched_film_.moment()) draw_film(step.frame, *touched_film_.moment());
    if (!Wall::is_touched())
        step.frame.captions = is_in_change(*this) && change_->began <= now
                                  ? kept_caption_rooms(shown_, change_->wall, shown_canvas_.bands)
                                  : caption_rooms(shown_, shown_canvas_.bands);
    step.retired =
        sources_.retire_all_but(sources_of({shown_, change_ ? change_->wall : shown_, touched_film_.shots()},
                                           copies_.with_copies(slots_.shots(), count_surfaces(canvas_))));
    return step;
}

/// Makes the new wall the shown one once its fade has ended.
void Wall::end_change(std::chrono::nanoseconds now) {
    if (change_->phase == Phase::arriving) {
        show_arrived(*change_, sources_, slots_, now);
        if (now - *change_->waiting_since >= settings_.patience)
            give_up_pending(*change_, sources_, *this, now);
    }
    const auto arrival =
        settings_.comes_at_once ? std::chrono::nanoseconds(0) : settings_.transition.duration;
    if (!has_ended(*change_, sources_, arrival, now)) return;
    if (change_->is_arranged && change_->canvas == canvas_) slots_.places_given();
    shown_canvas_ = change_->canvas;
    shown_ = std::move(change_->wall);
    change_.reset();
}

/// Goes on with the touches, and asks for the change of the wall that follows from them.
void Wall::follow_touch(std::chrono::nanoseconds now, WallStep& step) {
    const bool was_active = touch_.is_active();
    const TouchedWall wall = touched_wall(change_, shown_, canvas_);
    if (touch_.advance(now, wall, pace_.is_free(now))) pace_.note_change(now);
    TouchNeeds needs = touch_.take_needs();
    for (const SourceId source : needs.dismissed)
        if (!copies_.hide(source, now + settings_.slots.retry_after))
            slots_.dismiss_shot(copies_.original_of(source), now);
    if (needs.is_whole_over) touched_film_.end(now);
    if (needs.whole && needs.whole->shot.film) {
        touched_film_.begin(*needs.whole, ++*settings_.slots.numbers, now);
        const std::vector<ShotRequest> film = sources_.request(touched_film_.shots());
        step.requests.insert(step.requests.end(), film.begin(), film.end());
    }
    touched_film_.advance(now);
    if (was_active && !touch_.is_active() && !change_) needs.requests = sources_.request(shown_);
    step.requests.insert(step.requests.end(), needs.requests.begin(), needs.requests.end());
    if (change_ || canvas_ != shown_canvas_) return;
    std::optional<TouchedWay> way = touch_.next_way(wall);
    if (!way) return;
    change_ = WallChange{.phase = Phase::planned,
                         .generation = ++generation_,
                         .canvas = canvas_,
                         .wall = shown_,
                         .is_final = true,
                         .is_by_touch = true,
                         .duration = way->duration,
                         .drifts_after = way->request.wishes.empty()};
    step.plan = WallPlan{.generation = generation_,
                         .canvas = canvas_,
                         .items = {},
                         .way = std::make_shared<const WayRequest>(std::move(way->request))};
}

/// Starts a change if the slots hold other shots than those on the wall or on their way to it.
/// @return the plan of the new wall; none: nothing changes, or there is nothing to show
std::optional<WallPlan> Wall::follow_slots() {
    const std::vector<WallShot> wanted = copies_.with_copies(slots_.shots(), count_surfaces(canvas_));
    if (is_same(change_ ? change_->wall : shown_, wanted) && !must_plan_) return std::nullopt;
    must_plan_ = false;
    if (!change_ && wanted.empty() && shown_.empty()) return std::nullopt;
    change_ = WallChange{.phase = wanted.empty() ? Phase::laid_out : Phase::planned,
                         .generation = ++generation_,
                         .canvas = canvas_,
                         .is_final = wanted.empty()};
    for (const WallShot& shot : wanted)
        change_->wall.push_back({.shot = shot, .group = group_of(shot)});
    if (wanted.empty()) return std::nullopt;
    WallPlan plan{.generation = generation_, .canvas = canvas_, .items = plan_items(wanted, shown_)};
    change_->is_arranged = slots_.arranged() != nullptr;
    plan.keeps_places = change_->is_arranged;
    if (change_->is_arranged)
        give_arranged_places(plan.items, wanted, *slots_.arranged(), canvas_);
    else
        forget_places_of_few(plan.items);
    return plan;
}

/// Starts the fade when everything is ready and the time has come. Gives up on sources that are too late.
void Wall::wait_for_sources(std::chrono::nanoseconds now) {
    const bool can_arrive_singly =
        shown_.empty() && !settings_.is_calm && !settings_.comes_at_once && settings_.lead.count() == 0;
    if (!is_ready(*change_, sources_, can_arrive_singly)) {
        if (now - *change_->waiting_since >= patience_for(*change_, shown_, sources_, settings_.patience))
            give_up_pending(*change_, sources_, *this, now);
        return;
    }
    TransitionStyle style = settings_.transition;
    const bool is_behind_others = shown_.empty() && settings_.comes_at_once;
    std::chrono::nanoseconds lead = is_behind_others ? std::chrono::nanoseconds(0) : settings_.lead;
    if (brings_notice(*change_)) {
        style.duration = std::min(style.duration, max_notice_motion);
        lead = std::min(lead, max_notice_lead);
    }
    const bool is_other_canvas = change_->canvas != shown_canvas_;
    // on the way, hulls of groups might overlap
    style.moves = !is_other_canvas && !settings_.nests && !settings_.is_calm;
    const auto due = is_other_canvas ? std::nullopt : slots_.due();
    if ((due && now < *due - style.duration - lead) || !may_begin(pace_, now)) return;
    const std::chrono::nanoseconds begin = now + lead;
    if (settings_.photos_drift) give_drifts(change_->wall, shown_, change_->canvas.bands);
    if (is_other_canvas && !shown_.empty()) {
        const auto [scale, offset] = place_on(shown_canvas_, change_->canvas);
        begin_transition(*change_, transformed(shown_, scale, offset), style, begin);
    } else {
        begin_transition(*change_, shown_, style, begin);
    }
    if (change_->phase == Phase::arriving) {
        change_->waiting_since = begin;  // the others may come as late after the first
        return show_arrived(*change_, sources_, slots_, begin);
    }
    tell_appeared(*change_, slots_);
}

}  // namespace vitrine::player
