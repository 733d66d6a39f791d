#include "player/scene/files/shot_chooser.hpp"

#include <algorithm>

namespace vitrine::player {

namespace {

bool can_be_shown(const MediaRecord& record) {
    if (record.state != MediaState::ready || record.width <= 0 || record.height <= 0) return false;
    if (record.shots.empty()) return false;
    return record.kind == MediaKind::photo ||
           std::ranges::all_of(record.shots, [](const Shot& shot) { return shot.duration().count() > 0; });
}

}  // namespace

void WallFiles::set(const RecordList& records) {
    RecordList::Changes changes;
    records.for_each_change(given_, [&](const RecordList::Record& before, const RecordList::Record& now) {
        changes[(now ? now : before)->path] = now && can_be_shown(*now) ? now : nullptr;
    });
    given_ = records;
    shown_.apply(changes);
}

bool is_in_sequence(FilmShow film, std::size_t files) {
    return film == FilmShow::sequence || (film == FilmShow::automatic && files == 1);
}

void ShotChooser::set_files(const RecordList& files, const RecordList& before, const ShowHints& hints) {
    std::erase_if(avoided_, [&](const auto& avoided) {
        const RecordList::Record old = before.find(avoided.first);
        const RecordList::Record now = files.find(avoided.first);
        return !old || !now || !is_grown_from(*now, *old);
    });
    rotation_.set_files(files, hints);
    files_ = files.size();
}

std::set<std::string> ShotChooser::avoided_files() const {
    std::set<std::string> paths;
    for (const auto& [path, until] : avoided_)
        paths.insert(path);
    return paths;
}

bool ShotChooser::end_avoidance(std::chrono::nanoseconds now) {
    return std::erase_if(avoided_, [&](const auto& avoided) { return avoided.second <= now; }) > 0;
}

/// The next shot of one file, even before its turn.
std::optional<ShotKey> ShotChooser::next_shot_of(const std::string& path, const FreeSlot& slot) {
    const auto fits = [&](const ShotKey& key) { return key.path == path; };
    if (auto key = rotation_.next_shot(fits)) return key;
    rotation_.restart_finished(
        [&](const ShotKey& key) { return std::ranges::find(slot.on_wall, key) != slot.on_wall.end(); }, path);
    return rotation_.next_shot(fits);
}

std::optional<ShotKey> ShotChooser::next_shot(const FreeSlot& slot) {
    if (slot.pinned != nullptr)
        if (auto key = next_shot_of(*slot.pinned, slot)) return key;
    const auto stands = [&](const ShotKey& key) {
        return std::ranges::find(slot.on_wall, key) != slot.on_wall.end();
    };
    const auto count = [&](const std::string& path) {
        return std::ranges::count(slot.on_wall, path, &ShotKey::path);
    };
    const auto is_free = [&](const ShotKey& key) { return !is_avoided(key.path) && !stands(key); };
    const auto stands_alone = [&](const ShotKey& key) {
        return is_free(key) && count(key.path) == (key.path == slot.leaving ? 1 : 0);
    };
    // A shot beside another one of its own film is better than a free slot. But it does not replace another
    // file's only shot, unless the files take turns anyway and no shot may repeat yet.
    const bool can_double = slot.leaving.empty() || count(slot.leaving) > 1;
    const bool is_strict = !is_in_sequence(film_, files_);
    const bool takes_turns = files_ > slot.slots;
    if (auto key = rotation_.next_shot(stands_alone)) return key;
    if (is_strict && (can_double || takes_turns))
        if (auto key = rotation_.next_shot(is_free)) return key;
    if (is_strict && !rotation_.has_shot(is_free))
        rotation_.restart_all(stands);
    else
        rotation_.restart_finished(stands, is_strict ? slot.leaving : "");
    if (auto key = rotation_.next_shot(stands_alone)) return key;
    return can_double ? rotation_.next_shot(is_free) : std::nullopt;
}

}  // namespace vitrine::player
