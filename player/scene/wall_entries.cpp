#include "player/scene/wall_entries.hpp"

#include "player/scene/files/folder_shots.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace vitrine::player {

namespace {

/// The number of shots that stand for a folder: fewer where more entries share the wall.
std::size_t shots_of_folder(std::size_t entries) {
    constexpr std::size_t few = 8;
    constexpr std::size_t many = 16;
    return entries <= few ? 5 : entries <= many ? 4 : 3;
}

SlotSettings numbered(SlotSettings settings) {
    if (!settings.numbers) settings.numbers = std::make_shared<SourceId>(settings.last_source);
    return settings;
}

/// A record for a folder as an entry, which is never shown itself.
RecordList::Record stand_in(const std::string& folder, std::int64_t mtime_ns) {
    MediaRecord record{.path = folder,
                       .mtime_ns = mtime_ns,
                       .state = MediaState::ready,
                       .width = 1,
                       .height = 1,
                       .shots = {Shot{}}};
    return std::make_shared<const MediaRecord>(std::move(record));
}

std::vector<ShotKey> keys_of(const std::vector<WallShot>& shots) {
    std::vector<ShotKey> keys;
    keys.reserve(shots.size());
    for (const WallShot& shot : shots)
        keys.push_back(shot.key);
    return keys;
}

}  // namespace

WallEntries::WallEntries(const SlotSettings& settings, bool nests)
    : settings_(numbered(settings)), nests_(nests), slots_(settings_) {}

void WallEntries::set_catalogue(const RecordList& records, const ShowHints& hints) {
    hints_ = hints;
    if (!nests_) return slots_.set_catalogue(records, hints);
    const RecordList before = files_.all();
    files_.set(records);
    groups_.set_files(files_.all(), hints);
    give_entries();
    give_controls();
    refresh(before);
    follow_slots();
}

/// Tells the slots the entries of the level.
void WallEntries::give_entries() {
    const std::vector<FolderEntry> entries = level_entries(files_.all());
    entries_ = entries.size();
    if (std::ranges::none_of(entries, &FolderEntry::is_folder)) {
        stand_ins_.clear();
        return slots_.set_catalogue(files_.all(), hints_);
    }
    std::map<std::string, RecordList::Record> folders;
    std::vector<RecordList::Record> records;
    for (const FolderEntry& entry : entries) {
        if (!entry.is_folder) {
            records.push_back(files_.all().find(entry.path));
            continue;
        }
        const auto known = stand_ins_.find(entry.path);
        const RecordList::Record first = *files_.all().in_folder(entry.path).begin();
        records.push_back(folders[entry.path] = known != stand_ins_.end()
                                                    ? known->second
                                                    : stand_in(entry.path, first->mtime_ns));
    }
    stand_ins_ = std::move(folders);
    slots_.set_catalogue(RecordList(std::move(records)), hints_);
}

void WallEntries::set_controls(const ShowControls& controls) {
    const bool is_arranged = controls.arranged && controls.arranged != controls_.arranged;
    controls_ = controls;
    if (!is_arranged) return give_controls();
    awaited_ = controls.arranged;
    give_controls(controls.arranged);
    for (const WallShot& entry : slots_.shots())
        if (const auto folder = folders_.find(entry.source); folder != folders_.end())
            arrange(entry, folder->second);
    follow_slots();
}

/// Pins the entries of pinned files. @param arranged  is to be taken now
void WallEntries::give_controls(const std::shared_ptr<const ArrangedWall>& arranged) {
    ShowControls controls = controls_;
    controls.arranged = arranged;
    for (const auto& entry : stand_ins_) {
        const std::string inside = entry.first + '/';
        const auto is_inside = [&](const std::string& path) { return path.starts_with(inside); };
        if (std::erase_if(controls.files, is_inside) > 0) controls.files.insert(entry.first);
    }
    slots_.set_controls(controls);
}

void WallEntries::advance(std::chrono::nanoseconds now) {
    slots_.advance(now);
    if (!nests_) return;
    if (std::erase_if(avoided_, [&](const auto& entry) { return entry.second <= now; }) > 0)
        refresh(files_.all());
    follow_slots();
}

/// Chooses the shots of folders that have come, and forgets those of folders that have left.
void WallEntries::follow_slots() {
    std::map<SourceId, FolderShots> folders;
    for (const WallShot& entry : slots_.shots()) {
        if (!stand_ins_.contains(entry.key.path)) continue;
        const auto known = folders_.find(entry.source);
        FolderShots& shots = folders[entry.source];
        if (known != folders_.end())
            shots = std::move(known->second);
        else
            arrange(entry, shots);
    }
    folders_ = std::move(folders);
}

/// Follows changes of the files on the wall.
void WallEntries::refresh(const RecordList& before) {
    for (const WallShot& entry : slots_.shots()) {
        const auto folder = folders_.find(entry.source);
        if (folder == folders_.end()) continue;
        std::erase_if(folder->second, [&](WallShot& shot) {
            const RecordList::Record file = files_.all().find(shot.key.path);
            if (!file || shot.key.shot >= static_cast<int>(file->shots.size())) return true;
            if (!is_grown_from(*file, *before.find(shot.key.path))) return true;
            shot.shot = shot_now(*file, shot);  // the store may have it by now
            return false;
        });
        fill(entry, folder->second);
    }
}

/// Adds shots up to the number that stands for a folder.
void WallEntries::fill(const WallShot& entry, FolderShots& shots) {
    const std::size_t wanted =
        shots_of_folder(std::min(entries_, static_cast<std::size_t>(std::max(1, settings_.count))));
    if (shots.size() >= wanted) return;
    std::set<std::string> avoided;
    for (const auto& [path, until] : avoided_)
        avoided.insert(path);
    const std::vector<ShotKey> keys =
        folder_shots(groups_.heads().in_folder(entry.key.path), keys_of(shots), avoided, wanted);
    for (std::size_t i = shots.size(); i < keys.size(); ++i) {
        const RecordList::Record file = files_.all().find(keys[i].path);
        shots.push_back(wall_shot(*file, keys[i], ++*settings_.numbers, entry.slot));
        shots.back().film = film_of_photo(files_.all(), groups_, keys[i]);
        shots.back().folder = entry.key.path;
    }
}

/// Gives a folder the shots that it has in the arrangement, and further ones.
void WallEntries::arrange(const WallShot& entry, FolderShots& shots) {
    const FolderShots before = std::exchange(shots, {});
    for (const SlotShot& arranged : awaited_ ? awaited_->shots : std::vector<SlotShot>()) {
        const RecordList::Record file = files_.all().find(arranged.key.path);
        if (arranged.folder != entry.key.path || !file) continue;
        if (arranged.key.shot >= static_cast<int>(file->shots.size())) continue;
        const auto same = std::ranges::find(before, arranged.key, &WallShot::key);
        shots.push_back(
            same != before.end() ? *same : wall_shot(*file, arranged.key, ++*settings_.numbers, entry.slot));
        shots.back().slot = entry.slot;
        shots.back().folder = entry.key.path;
    }
    if (!awaited_) shots = before;
    fill(entry, shots);
}

std::map<SourceId, WallEntries::FolderShots>::iterator WallEntries::folder_with(SourceId source) {
    return std::ranges::find_if(folders_, [&](const auto& folder) {
        return std::ranges::find(folder.second, source, &WallShot::source) != folder.second.end();
    });
}

/// The time of a folder begins with its first shot.
void WallEntries::shot_appeared(SourceId source, std::chrono::nanoseconds now) {
    const auto folder = folder_with(source);
    slots_.shot_appeared(folder == folders_.end() ? source : folder->first, now);
}

void WallEntries::source_failed(SourceId source, std::chrono::nanoseconds now) {
    if (folder_with(source) == folders_.end())
        slots_.source_failed(source, now);
    else
        avoid(source, now);
    follow_slots();
}

void WallEntries::dismiss_shot(SourceId source, std::chrono::nanoseconds now) {
    if (folder_with(source) == folders_.end())
        slots_.dismiss_shot(source, now);
    else
        avoid(source, now);
    follow_slots();
}

/// Shows other files of its folder in place of a shot's file. A folder without any leaves as a file does.
void WallEntries::avoid(SourceId source, Time now) {
    const auto folder = folder_with(source);
    FolderShots& shots = folder->second;
    const std::string path = std::ranges::find(shots, source, &WallShot::source)->key.path;
    avoided_[path] = now + settings_.retry_after;
    std::erase_if(shots, [&](const WallShot& shot) { return shot.key.path == path; });
    const std::vector<WallShot> entries = slots_.shots();
    const auto entry = std::ranges::find(entries, folder->first, &WallShot::source);
    fill(*entry, shots);
    if (shots.empty()) slots_.source_failed(entry->source, now);
}

std::set<std::string> WallEntries::avoided_files() const {
    std::set<std::string> paths = slots_.avoided_files();
    std::erase_if(paths, [&](const std::string& path) { return stand_ins_.contains(path); });
    for (const auto& [path, until] : avoided_)
        paths.insert(path);
    return paths;
}

std::vector<WallShot> WallEntries::shots() const {
    std::vector<WallShot> shots;
    for (const WallShot& entry : slots_.shots()) {
        const auto folder = folders_.find(entry.source);
        if (folder == folders_.end())
            shots.push_back(entry);
        else
            shots.insert(shots.end(), folder->second.begin(), folder->second.end());
    }
    return shots;
}

}  // namespace vitrine::player
