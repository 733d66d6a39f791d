#include "player/scene/pan/panning_shots.hpp"

#include <algorithm>
#include <optional>

namespace vitrine::player {

void PanningShots::set_files(const RecordList& records, const ShowHints& hints) {
    files_.set(records);
    groups_.set_files(files_.all(), hints);
    rotation_.set_files(groups_.heads(), hints);
}

std::size_t PanningShots::count_shots(std::size_t most) const {
    std::size_t count = 0;
    for (const RecordList::Record& record : groups_.heads()) {
        if (count >= most) break;
        count += record->shots.size();
    }
    return std::min(count, most);
}

std::vector<WallShot> PanningShots::next_shots(std::size_t count,
                                               const std::function<bool(const ShotKey&)>& is_on_wall) {
    std::vector<WallShot> shots;
    const auto stands = [&](const ShotKey& key) {
        return is_on_wall(key) || std::ranges::find(shots, key, &WallShot::key) != shots.end();
    };
    const auto is_new = [&](const ShotKey& key) {
        if (stands(key)) return false;
        return !groups_.has_others(key.path, [&](const std::string& path) { return stands({path, 0}); });
    };
    while (shots.size() < count) {
        std::optional<ShotKey> key = rotation_.next_shot(is_new);
        if (!key) {
            rotation_.restart_finished(is_on_wall);
            key = rotation_.next_shot(is_new);
        }
        if (!key) key = rotation_.next_shot([](const ShotKey&) { return true; });
        if (!key) break;
        if (key->shot == 0)
            if (auto path = groups_.take_turn(key->path, [](const std::string&) { return true; }))
                key->path = std::move(*path);
        shots.push_back(wall_shot(*files_.all().find(key->path), *key, ++last_source_, 0));
    }
    return shots;
}

}  // namespace vitrine::player
