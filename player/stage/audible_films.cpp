#include "player/stage/audible_films.hpp"

namespace vitrine::player {

void AudibleFilms::note(const ShotRequest& request, const RecordList& records) {
    if (request.kind != MediaKind::film) return;
    const RecordList::Record record = records.find(request.path);
    films_[request.source] = {.source = request.source,
                              .path = request.path,
                              .begin = request.shot.begin,
                              .end = request.shot.end,
                              .stored = record ? record->sound : std::nullopt};
}

std::vector<AudibleShot> AudibleFilms::shots(const Frame& frame, const ShowHints& hints) const {
    std::vector<AudibleShot> shots;
    for (const DrawItem& item : frame.items) {
        const auto film = films_.find(item.source);
        if (film == films_.end()) continue;
        const auto said = hints.find(film->second.path);
        if (!said || !said->hints.sound.value_or(false)) continue;
        AudibleShot& shot = shots.emplace_back(film->second);
        const Vec2 size = item.picture * item.placement.scale;
        shot.area = size.x * size.y;
        shot.middle = item.placement.offset + size * 0.5 - frame.view;
        shot.local = item.local;
    }
    return shots;
}

}  // namespace vitrine::player
