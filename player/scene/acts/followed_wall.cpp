#include "player/scene/acts/followed_wall.hpp"

#include <algorithm>
#include <utility>

namespace vitrine::player {

namespace {

using std::chrono::nanoseconds;

constexpr auto patience = std::chrono::seconds(10);           // with shots that are not there
constexpr auto clock_patience = std::chrono::seconds(5);      // of the first act, with a clock that is wrong
constexpr auto longest_frame = std::chrono::seconds(2);       // a longer one: no screen has shown the wall
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

/// True if an act begins with the wall that another one shows now.
bool is_next(const WallAct& act, const WallAct& shown, nanoseconds shared) {
    if (act.pan || shown.pan) return false;
    if (act.name.run != shown.name.run || act.name.generation != shown.name.generation + 1) return false;
    const nanoseconds latest = leaders_time(act, shared) - begins_late;
    const bool has_way = act.folder && act.folder->began;
    return (!act.change || latest <= act.change->began) && (!has_way || latest <= *act.folder->began);
}

/// True if an act is of the same panning wall as another one: all goes on where it is. A wall that has begun
/// anew, for a notice, has no shot of the other.
bool is_further(const WallAct& act, const WallAct& shown) {
    const auto is_known = [&](const PlacedShot& placed) {
        return find_source(shown.shown, placed.shot.source) != nullptr;
    };
    return shown.pan && act.pan && act.name.run == shown.name.run && act.canvas == shown.canvas &&
           (shown.shown.empty() || std::ranges::any_of(act.shown, is_known));
}

}  // namespace

void FollowedWall::take(const WallAct& act) {
    const std::optional<WallAct>& last = waiting_ ? waiting_ : shown_;
    if (last && !is_newer(act.name, last->name)) return;
    if (last && last->name.run != act.name.run) lifted_.take({}, {}, now_);
    if (!waiting_) waiting_since_ = now_;
    waiting_ = sources_.translated(act);
}

void FollowedWall::prepare(const WallAct& coming) {
    if (!prepared_ || is_newer(coming.name, prepared_->name)) prepared_ = sources_.translated(coming);
}

void FollowedWall::take_lifted(ToldHands told) {
    const std::int64_t run = told.run;
    LiftedMoment& seen = told.lifted;
    for (LiftedMoment::Shot& shot : seen.shots)
        shot.source = sources_.find_own(run, shot.source).value_or(0);
    for (auto* const act : {&shown_, &waiting_})
        if (seen.view && *act && (*act)->pan && (*act)->name.run == run)
            (*act)->pan->course = {.view = *seen.view, .last = *seen.view};
    if (seen.film) seen.film->shot.source = sources_.own_number(run, seen.film->shot.source);
    if (told.tapestry) told.tapestry = moved(*told.tapestry, -epoch_);
    lifted_.take(std::move(seen), std::move(told.tapestry), now_);
}

bool FollowedWall::is_between_acts() const {
    return waiting_.has_value() || !shown_ || has_ended(*shown_, leaders_time(*shown_, now_ + epoch_));
}

FollowedState FollowedWall::state() const {
    FollowedState state;
    if (shown_) state.shown = shown_->name;
    for (const auto* act : {&shown_, &waiting_, &prepared_}) {
        if (!*act) continue;
        for (const PlacedShot* placed : sources_.lacking(**act)) {
            state.lacking.insert(placed->shot.key.path);
            if (const auto& stored = placed->shot.shot.stored) state.wanted.insert(stored->file);
        }
    }
    if (prepared_ && sources_.are_there(*prepared_)) state.prepared = prepared_->name;
    return state;
}

/// Shows the act that waits, if its time has come. One that goes on elsewhere, or on another canvas, comes
/// when its change begins.
void FollowedWall::take_waiting() {
    if (!waiting_) return;
    const nanoseconds waited = now_ - waiting_since_;
    const bool has_time = shown_ || is_clock_right_ || waited >= clock_patience;
    if (!(has_time && sources_.are_there(*waiting_)) && waited < patience) return;
    const nanoseconds shared = now_ + epoch_;
    const bool goes_on = shown_ && (is_next(*waiting_, *shown_, shared) || is_further(*waiting_, *shown_));
    std::optional<WallChange>& change = waiting_->change;
    if (shown_ && !(goes_on && waiting_->canvas == shown_->canvas) && change &&
        leaders_time(*waiting_, shared) < change->began)
        return;
    if (shown_ && !goes_on) {
        if (change && change->phase == WallChange::Phase::arriving) {
            waiting_->shown = std::move(change->wall);  // it need not come out of nothing
            change.reset();
        }
        if (waiting_->folder) waiting_->folder->began.reset();
        const Vec2 view = act_frame(*waiting_, leaders_time(*waiting_, shared)).view;
        fade_.begin(view, place_on(*shown_, *waiting_), now_);
    }
    names_.place_anew();
    shown_ = std::exchange(waiting_, std::nullopt);
    bezels_ = bezels_of(*shown_);
    lifted_.set_canvas(shown_->canvas);
}

/// The frame of the shown act, which may fade in over what was shown before.
Frame FollowedWall::next_frame() {
    if (!shown_) return Frame{.canvas = canvas_, .idle = 1, .time = now_};
    const nanoseconds leaders = leaders_time(*shown_, now_ + epoch_);
    Frame wall = wall_frame(*shown_, leaders);
    const FilmMoment* const film = lifted_.film();
    lifted_.draw(wall, has_ended(*shown_, leaders) ? last_wall(*shown_) : shown_->shown,
                 film != nullptr && sources_.is_ready(film->shot.source), now_);
    Frame frame = act_frame(*shown_, wall, leaders);
    fade_.draw(frame, now_);
    const bool stands = lifted_.is_empty() && has_ended(*shown_, leaders);  // but for films and what passes
    if (stands) {
        names_.stand(last_wall(*shown_), shown_->canvas, shown_->folder ? shown_->folder->mark : Box{}, now_);
        frame.names = names_.at(now_);
    } else {
        names_.hide();
    }
    frame.time = now_;
    return frame;
}

WallStep FollowedWall::step(nanoseconds now) {
    if (now - now_ > longest_frame) waiting_since_ = now;
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
    if (shown_ && lifted_.is_empty())
        step.frame.captions = captions_of(*shown_, bezels_, leaders_time(*shown_, now_ + epoch_));
    std::set<SourceId> kept;
    for (const auto* act : {&shown_, &waiting_, &prepared_}) {
        const std::vector<const WallAct*> walls = *act ? walls_of(**act) : std::vector<const WallAct*>();
        for (const WallAct* const wall : walls)
            for (const auto& [source, placed] : shots_of(*wall))
                kept.insert(source);
    }
    for (const DrawItem& item : fade_.items())
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
