#include "player/scene/acts/led_show.hpp"

#include "player/scene/show_controls.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace vitrine::player {

void LedShow::set_catalogue(const RecordList& records, const ShowHints& hints) {
    ForwardingShow::set_catalogue(records, hints);
    if (!awaited_.is_waiting(now_)) return;
    std::vector<WallShot> known;
    for (const PlacedShot& placed : prepared_.shown) {
        const RecordList::Record record = records.find(placed.shot.key.path);
        if (!record || placed.shot.key.shot >= static_cast<int>(record->shots.size())) continue;
        known.push_back(placed.shot);
        known.back().shot = shot_now(*record, placed.shot);
    }
    if (update_stored(prepared_.shown, known).empty()) return;
    prepared_.name.generation = awaited_.prepare_again();
    preparation_ = prepared_;
}

void LedShow::set_controls(const ShowControls& controls) {
    ForwardingShow::set_controls(controls);
    if (std::exchange(is_paused_, controls.is_paused) != controls.is_paused) wants_act_ = true;
}

void LedShow::source_ready(SourceId source) {
    if (awaited_.is_waiting(now_))
        awaited_.hold(source);
    else
        ForwardingShow::source_ready(source);
}

WallStep LedShow::step(std::chrono::nanoseconds now) {
    now_ = now;
    for (const SourceId source : awaited_.take_free(now))
        ForwardingShow::source_ready(source);
    WallStep step = ForwardingShow::step(now);
    for (const SourceId source : step.retired)
        awaited_.forget(source);
    make_news();
    return step;
}

void LedShow::heed(const LedOthers& others) {
    awaited_.set_ready(others.ready);
    if (others.needs_act) wants_act_ = true;
}

LedNews LedShow::take_news() {
    return {.act = std::exchange(act_, std::nullopt),
            .preparation = std::exchange(preparation_, std::nullopt),
            .lifted = lifted(),
            .tapestry = tapestry_,
            .now = local_time()};
}

void LedShow::set_parts(std::vector<ActParts> parts) {
    if (parts == parts_) return;
    parts_ = std::move(parts);
    wants_act_ = true;
}

void LedShow::prepare(const std::vector<PlacedShot>& shots, const Canvas& canvas, const CellStyle& cells) {
    prepared_ = WallAct{
        .name = {.generation = awaited_.prepare(now_)}, .canvas = canvas, .cells = cells, .shown = shots};
    preparation_ = prepared_;
}

void LedShow::tell(WallAct act) {
    wants_act_ = false;
    if (acts_ == 0 && last_wall(act).empty()) return;
    act.name.generation = ++acts_;
    act.words = words_;
    act.is_paused = is_paused_;
    const auto same = std::ranges::find(parts_, act.canvas, &ActParts::canvas);
    if (same != parts_.end()) act.parts = same->parts;
    act_ = std::move(act);
}

}  // namespace vitrine::player
