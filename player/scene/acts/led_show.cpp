#include "player/scene/acts/led_show.hpp"

#include <utility>

namespace vitrine::player {

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

void LedShow::set_parts(std::map<std::string, ActPart> parts) {
    if (parts == parts_) return;
    parts_ = std::move(parts);
    wants_act_ = true;
}

void LedShow::prepare(const std::vector<PlacedShot>& shots, const Canvas& canvas, const CellStyle& cells) {
    preparation_ = WallAct{
        .name = {.generation = awaited_.prepare(now_)}, .canvas = canvas, .cells = cells, .shown = shots};
}

void LedShow::tell(WallAct act) {
    wants_act_ = false;
    if (acts_ == 0 && last_wall(act).empty()) return;
    act.name.generation = ++acts_;
    act.parts = parts_;
    act_ = std::move(act);
}

}  // namespace vitrine::player
