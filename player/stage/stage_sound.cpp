#include "player/stage/stage.hpp"

#include <algorithm>

// What of a stage may be heard.

namespace vitrine::player {

void Stage::set_controls(const ShowControls& controls) {
    is_paused_ = controls.is_paused;
    show_->set_controls(controls);
}

void Stage::note_film(const ShotRequest& request) {
    if (request.kind != MediaKind::film) return;
    const RecordList::Record record = records_.find(request.path);
    films_[request.source] = {.source = request.source,
                              .path = request.path,
                              .begin = request.shot.begin,
                              .end = request.shot.end,
                              .stored = record ? record->sound : std::nullopt};
}

std::vector<AudibleShot> Stage::audible() const {
    std::vector<AudibleShot> shots;
    if (is_paused_ || screens_.empty()) return shots;
    for (const DrawItem& item : frame_.items) {
        const auto film = films_.find(item.source);
        if (film == films_.end()) continue;
        const auto hints = hints_.find(film->second.path);
        if (hints == hints_.end() || !hints->second.sound.value_or(false)) continue;
        AudibleShot& shot = shots.emplace_back(film->second);
        const Vec2 size = item.picture * item.placement.scale;
        shot.area = size.x * size.y;
        shot.local = item.local;
    }
    return shots;
}

}  // namespace vitrine::player
