#include "player/scene/acts/followed_wall.hpp"

#include "player/layout/cells/cut_cell.hpp"
#include "player/scene/caption_place.hpp"
#include "player/scene/crossfade.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace vitrine::player {

namespace {

using std::chrono::nanoseconds;

constexpr auto patience = std::chrono::seconds(10);       // with shots that are not there
constexpr auto clock_patience = std::chrono::seconds(5);  // of the first act, with a clock that is wrong
constexpr auto fade_time =
    std::chrono::milliseconds(800);  // from what was shown to an act that goes on elsewhere
constexpr auto begins_late = std::chrono::milliseconds(100);  // so late a change is still seen as it is meant

/// True for a later act, and for one of another run of the leader, whose clock may have been wrong.
bool is_newer(const ActName& one, const ActName& other) {
    return one.run != other.run || one.generation > other.generation;
}

/// The time of the leader's wall. @param shared  since 1970
nanoseconds leaders_time(const WallAct& act, nanoseconds shared) {
    return shared - act.epoch;
}

void append(std::vector<ShotRequest>& all, std::vector<ShotRequest> more) {
    all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

/// The same items elsewhere on the canvas.
std::vector<DrawItem> moved_by(std::vector<DrawItem> items, Vec2 way) {
    if (way == Vec2{}) return items;
    for (DrawItem& item : items) {
        item.placement.offset = item.placement.offset + way;
        item.cell = std::make_shared<const Cell>(scaled_cell(*item.cell, 1, way));
    }
    return items;
}

/// Items of a frame some time later: their films play on, in step with the same films in another frame.
std::vector<DrawItem> played_on(std::vector<DrawItem> items, const std::vector<DrawItem>& others,
                                nanoseconds passed) {
    for (DrawItem& item : items) {
        const auto same = std::ranges::find(others, item.source, &DrawItem::source);
        item.local = same != others.end() ? same->local : item.local + passed;
    }
    return items;
}

}  // namespace

void FollowedWall::take(const WallAct& act) {
    const std::optional<WallAct>& last = waiting_ ? waiting_ : shown_;
    if (last && !is_newer(act.name, last->name)) return;
    if (!waiting_) waiting_since_ = now_;
    waiting_ = sources_.translated(act);
}

void FollowedWall::prepare(const WallAct& coming) {
    if (!prepared_ || is_newer(coming.name, prepared_->name)) prepared_ = sources_.translated(coming);
}

void FollowedWall::take_lifted(std::int64_t run, LiftedMoment seen) {
    for (LiftedMoment::Shot& shot : seen.shots)
        shot.source = sources_.find_own(run, shot.source).value_or(0);
    for (auto* const act : {&shown_, &waiting_})
        if (seen.view && *act && (*act)->pan && (*act)->name.run == run)
            (*act)->pan->course = {.view = *seen.view, .last = *seen.view};
    if (seen.film) seen.film->shot.source = sources_.own_number(run, seen.film->shot.source);
    lifted_.take(std::move(seen), now_);
}

bool FollowedWall::is_between_acts() const {
    return waiting_.has_value() || !shown_ || has_ended(*shown_, leaders_time(*shown_, now_ + epoch_));
}

FollowedState FollowedWall::state() const {
    FollowedState state;
    if (shown_) {
        state.shown = shown_->name;
        state.lacking = sources_.lacking(*shown_);
    }
    for (const auto* act : {&waiting_, &prepared_})
        if (*act) state.lacking.merge(sources_.lacking(**act));
    if (prepared_ && sources_.are_there(*prepared_)) state.prepared = prepared_->name;
    return state;
}

/// True if the act begins with the wall that is shown now.
bool FollowedWall::is_next(const WallAct& act) const {
    if (!shown_ || act.name.run != shown_->name.run || act.name.generation != shown_->name.generation + 1)
        return false;
    return !act.change || leaders_time(act, now_ + epoch_) <= act.change->began + begins_late;
}

/// True if the act is of the panning wall that is shown now, on which all goes on where it is.
bool FollowedWall::is_further(const WallAct& act) const {
    return shown_ && shown_->pan && act.pan && act.name.run == shown_->name.run &&
           act.canvas == shown_->canvas;
}

/// Shows the act that waits, if its time has come. One that goes on elsewhere comes when its change begins.
void FollowedWall::take_waiting() {
    if (!waiting_) return;
    const nanoseconds waited = now_ - waiting_since_;
    const bool has_time = shown_ || is_clock_right_ || waited >= clock_patience;
    if (!(has_time && sources_.are_there(*waiting_)) && waited < patience) return;
    if (shown_ && !is_next(*waiting_) && !is_further(*waiting_)) {
        std::optional<WallChange>& change = waiting_->change;
        if (change && leaders_time(*waiting_, now_ + epoch_) < change->began) return;
        if (change && change->phase == WallChange::Phase::arriving) {
            waiting_->shown = std::move(change->wall);  // it need not come out of nothing
            change.reset();
        }
        const Vec2 view = act_frame(*waiting_, leaders_time(*waiting_, now_ + epoch_)).view;
        before_ = moved_by(std::exchange(last_, {}), view - std::exchange(last_view_, view));
        fades_since_ = now_;
    }
    shown_ = std::exchange(waiting_, std::nullopt);
}

/// The frame of the shown act, which may fade in over what was shown before.
Frame FollowedWall::next_frame() {
    if (!shown_) return Frame{.canvas = canvas_, .idle = 1, .time = now_};
    Frame frame = act_frame(*shown_, leaders_time(*shown_, now_ + epoch_));
    last_ = frame.items;
    last_view_ = frame.view;
    if (fades_since_) {
        const double progress =
            std::chrono::duration<double>(now_ - *fades_since_) / std::chrono::duration<double>(fade_time);
        if (progress < 1)
            fade_in(frame, played_on(before_, frame.items, now_ - *fades_since_), progress);
        else
            fades_since_.reset(), before_.clear();
    }
    const bool has_ended_now = has_ended(*shown_, frame.time);
    lifted_.draw(frame, has_ended_now ? last_wall(*shown_) : shown_->shown, now_);
    const FilmMoment* const film = lifted_.film();
    if (film != nullptr && sources_.is_ready(film->shot.source)) draw_film(frame, *film);
    frame.time = now_;
    return frame;
}

/// The rooms for captions in the frame, as the leader has them. None while a hand moves shots.
std::vector<CaptionRoom> FollowedWall::caption_places() const {
    if (!shown_ || shown_->pan || !lifted_.is_empty()) return {};
    std::vector<Box> outputs;
    for (const auto& [name, part] : shown_->parts)
        outputs.push_back(part.box);
    const std::vector<Box> bezels = canvas_of(shown_->canvas, std::move(outputs)).bands;
    if (has_ended(*shown_, leaders_time(*shown_, now_ + epoch_)))
        return caption_rooms(last_wall(*shown_), bezels);
    return shown_->change->way ? std::vector<CaptionRoom>()
                               : kept_caption_rooms(shown_->shown, last_wall(*shown_), bezels);
}

WallStep FollowedWall::step(nanoseconds now) {
    now_ = now;
    WallStep step;
    sources_.show_larger(lifted_.whole_pictures());
    if (prepared_) append(step.requests, sources_.ask_for(*prepared_, std::nullopt, now));
    for (const auto* act : {&shown_, &waiting_})
        if (*act) append(step.requests, sources_.ask_for(**act, leaders_time(**act, now_ + epoch_), now));
    if (const FilmMoment* const film = lifted_.film(); film != nullptr && shown_)
        if (auto request = sources_.ask_for(*film, leaders_time(*shown_, now_ + epoch_), now))
            step.requests.push_back(std::move(*request));
    take_waiting();
    step.frame = next_frame();
    step.frame.captions = caption_places();
    std::set<SourceId> kept;
    for (const auto* act : {&shown_, &waiting_, &prepared_})
        if (*act)
            for (const auto& [source, placed] : shots_of(**act))
                kept.insert(source);
    for (const DrawItem& item : before_)
        kept.insert(item.source);
    if (const FilmMoment* const film = lifted_.film()) kept.insert(film->shot.source);
    step.retired = sources_.retire_all_but(kept);
    for (const SourceId source : sources_.give_up_failed(now))
        step.retired.push_back(source);
    return step;
}

std::vector<SlotShot> FollowedWall::standing() const {
    std::vector<SlotShot> all;
    if (!shown_) return all;
    for (const PlacedShot& placed : last_wall(*shown_))
        all.push_back({.slot = placed.shot.slot, .key = placed.shot.key, .at = placed.placement});
    return all;
}

}  // namespace vitrine::player
