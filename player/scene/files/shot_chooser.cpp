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
    groups_.set_files(files, hints);
    rotation_.set_files(groups_.heads(), hints);
    files_ = groups_.heads().size();
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

/// The same wall with the files that have the turns of the groups.
FreeSlot ShotChooser::by_heads(const FreeSlot& slot) const {
    FreeSlot result = slot;
    for (ShotKey& key : result.on_wall) {
        const std::string head = groups_.head_of(key.path);
        if (head != key.path) key = {head, 0};
    }
    if (!slot.leaving.empty()) result.leaving = groups_.head_of(slot.leaving);
    return result;
}

std::optional<ShotKey> ShotChooser::next_shot(const FreeSlot& slot) {
    const auto is_fit = [&](const std::string& path) { return !is_avoided(path) && path != slot.leaving; };
    if (slot.pinned != nullptr) {
        if (groups_.head_of(*slot.pinned) != *slot.pinned) return ShotKey{*slot.pinned, 0};
        if (auto key = next_shot_of(*slot.pinned, slot)) return key;
    }
    std::optional<ShotKey> key = next_head(by_heads(slot));
    // If nothing else waits, the others of a group take its place.
    if (!key && !slot.leaving.empty() && groups_.has_others(slot.leaving, is_fit))
        key = ShotKey{groups_.head_of(slot.leaving), 0};
    if (!key || key->shot > 0) return key;
    if (auto path = groups_.take_turn(key->path, is_fit)) key->path = std::move(*path);
    return key;
}

/// @param slot  by_heads()
std::optional<ShotKey> ShotChooser::next_head(const FreeSlot& slot) {
    const auto stands = [&](const ShotKey& key) {
        return std::ranges::find(slot.on_wall, key) != slot.on_wall.end();
    };
    const auto count = [&](const std::string& path) {
        return std::ranges::count(slot.on_wall, path, &ShotKey::path);
    };
    const auto is_unavoided = [&](const std::string& path) { return !is_avoided(path); };
    const auto is_free = [&](const ShotKey& key) {
        return groups_.has_turn(key.path, is_unavoided) && !stands(key);
    };
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
