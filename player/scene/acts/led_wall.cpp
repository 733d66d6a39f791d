#include "player/scene/acts/led_wall.hpp"

#include <algorithm>
#include <utility>

namespace vitrine::player {

namespace {

using Phase = WallChange::Phase;

/// The change as it is seen: without what was needed to come to it.
WallChange seen_change(const WallChange& change) {
    return {.phase = change.phase,
            .generation = change.generation,
            .canvas = change.canvas,
            .wall = change.wall,
            .is_final = true,
            .duration = change.duration,
            .way = change.way,
            .began = change.began,
            .transition = change.transition};
}

/// The wall as it is now.
WallAct act_of(const WallParts& parts, const WallSettings& settings) {
    WallAct act{.canvas = parts.canvas,
                .cells = settings.transition.cells,
                .fade = settings.transition.duration,
                .shown = {parts.shown.begin(), parts.shown.end()}};
    if (!parts.change || !parts.change->is_fading()) return act;
    act.change = seen_change(*parts.change);
    act.canvas = parts.change->canvas;
    if (!act.change->transition) return act;
    act.shown.clear();  // as the transition has it, on its own canvas
    for (const ChangingShot& shot : act.change->transition->old_wall)
        act.shown.push_back(shot.placed);
    return act;
}

}  // namespace

void LedWall::set_catalogue(const RecordList& records, const ShowHints& hints) {
    const std::vector<PlacedShot> before = last_wall(
        {.shown = {wall_.parts().shown.begin(), wall_.parts().shown.end()}, .change = wall_.parts().change});
    wall_.set_catalogue(records, hints);
    for (const PlacedShot& now : wall_.parts().shown) {
        const PlacedShot* const same = find_source(before, now.shot.source);
        if (same != nullptr && same->shot.shot.stored != now.shot.shot.stored) is_told_ = false;
    }
}

void LedWall::source_ready(SourceId source) {
    if (awaited_.is_waiting(now_))
        awaited_.hold(source);
    else
        wall_.source_ready(source);
}

LedNews LedWall::take_news() {
    LiftedMoment lifted = wall_.parts().lifted.moment(now_);
    lifted.film = wall_.parts().film;
    return {.act = std::exchange(act_, std::nullopt),
            .preparation = std::exchange(preparation_, std::nullopt),
            .lifted = std::move(lifted),
            .now = now_};
}

void LedWall::heed(const LedOthers& others) {
    awaited_.set_ready(others.ready);
    if (others.needs_act) is_told_ = false;
}

void LedWall::set_parts(std::map<std::string, ActPart> parts) {
    if (parts == parts_) return;
    parts_ = std::move(parts);
    is_told_ = false;
}

WallStep LedWall::step(std::chrono::nanoseconds now) {
    now_ = now;
    for (const SourceId source : awaited_.take_free(now))
        wall_.source_ready(source);
    WallStep step = wall_.step(now);
    for (const SourceId source : step.retired)
        awaited_.forget(source);
    make_news();
    return step;
}

/// Tells of the shots that come, once for each change, and makes an act once the change is decided.
void LedWall::make_news() {
    const WallParts parts = wall_.parts();
    const std::optional<WallChange>& change = parts.change;
    if (change && change->phase == Phase::waiting && change->generation != prepared_change_) {
        prepared_change_ = change->generation;
        preparation_ = WallAct{.name = {.generation = awaited_.prepare(now_)},
                               .canvas = change->canvas,
                               .cells = settings_.transition.cells,
                               .shown = change->wall};
    }
    const bool is_seen = change && change->is_fading();
    const bool is_new = is_seen && change->generation != told_change_;
    if (is_told_ && !is_new) return;
    is_told_ = true;
    if (is_seen) told_change_ = change->generation;
    if (acts_ == 0 && parts.shown.empty() && !is_seen) return;  // others may still show the last run's wall
    act_ = act_of(parts, settings_);
    act_->name.generation = ++acts_;
    act_->parts = parts_;
}

}  // namespace vitrine::player
