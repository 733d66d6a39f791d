#include "player/scene/files/file_groups.hpp"

#include "base/state/path_text.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <tuple>
#include <utility>

namespace vitrine::player {

namespace {

constexpr std::size_t max_candidates = 8;  // that a photo is compared with

bool is_ready(const RecordList::Record& record) {
    return record && record->state == MediaState::ready && !record->shots.empty();
}

bool has_print(const MediaRecord& record) {
    const Shot& shot = record.shots.front();
    return record.kind == MediaKind::photo && shot.print && shot.look;
}

/// The names under which the halves of a Live Photo find each other.
std::vector<std::string> live_names(const MediaRecord& record) {
    const std::string_view path = record.path;
    const std::size_t name_at = path.rfind('/') + 1;
    std::vector<std::string> names{"name " + std::string(path.substr(0, name_at)) +
                                   lower_case(stem_of(path))};
    if (!record.origin.content_id.empty()) names.push_back("id " + record.origin.content_id);
    return names;
}

/// Photos are better the more of the take they show, and then the sharper they are.
bool is_better(const RecordList::Record& a, const RecordList::Record& b) {
    constexpr double steps = 4;  // for a doubling of the pixels
    const auto rank = [](const RecordList::Record& record) {
        const double pixels = std::max(1.0, static_cast<double>(record->width) * record->height);
        const auto& print = record->shots.front().print;
        return std::pair(std::round(std::log2(pixels) * steps), print ? print->sharpness : 0);
    };
    const auto rank_a = rank(a), rank_b = rank(b);
    return rank_a != rank_b ? rank_a > rank_b : a->path < b->path;
}

}  // namespace

void FileGroups::set_files(const RecordList& files) {
    std::vector<RecordList::Record> added;
    files.for_each_change(files_, [&](const RecordList::Record& before, const RecordList::Record& now) {
        if (is_ready(before)) remove(*before);
        if (is_ready(now)) added.push_back(now);
    });
    files_ = files;
    for (const RecordList::Record& record : added)
        add(record);
    if (!touched_.empty()) regroup_touched();
}

void FileGroups::remove(const MediaRecord& record) {
    touched_.insert(record.path);
    std::erase_if(compared_, [&](const auto& known) {
        return known.first.first == record.path || known.first.second == record.path;
    });
    for (auto* links : {&near_, &live_}) {
        const auto found = links->find(record.path);
        if (found == links->end()) continue;
        for (const std::string& other : found->second) {
            touched_.insert(other);
            (*links)[other].erase(record.path);
        }
        links->erase(record.path);
    }
    for (const std::string& name : live_names(record))
        if (const auto found = by_name_.find(name); found != by_name_.end()) found->second.erase(record.path);
    const auto place = place_.find(record.path);
    if (place == place_.end()) return;
    photos_[place->second] = photos_.back();
    place_[photos_.back().record->path] = place->second;
    photos_.pop_back();
    place_.erase(record.path);
}

void FileGroups::add(const RecordList::Record& record) {
    join_live_pairs(record);
    if (!has_print(*record)) return;
    const Known photo{
        .record = record, .hashes = hashes_of(record->shots.front()), .facts = facts_of(*record)};
    for (const RecordList::Record& other : candidates(photo))
        if (are_near_copies(*record, *other)) link(record->path, other->path);
    place_[record->path] = photos_.size();
    photos_.push_back(photo);
}

/// The photos whose hashes are nearest.
std::vector<RecordList::Record> FileGroups::candidates(const Known& photo) const {
    constexpr int max_distance = 44;
    std::vector<std::pair<int, const Known*>> near;
    for (const Known& other : photos_) {
        const Kinship kin = kinship(photo.facts, other.facts);
        if (kin == Kinship::strangers) continue;
        const int distance = distance_between(photo.hashes, other.hashes);
        if (distance > copy_limits(kin).max_hash_distance) continue;
        if (!may_be_copies(photo.record->shots.front(), other.record->shots.front(), kin)) continue;
        const bool is_kin = kin == Kinship::copies || kin == Kinship::sequence;
        near.emplace_back(is_kin ? distance - max_distance : distance, &other);
    }
    const std::size_t count = std::min(max_candidates, near.size());
    std::ranges::partial_sort(near, near.begin() + static_cast<std::ptrdiff_t>(count), {},
                              &std::pair<int, const Known*>::first);
    std::vector<RecordList::Record> records;
    for (std::size_t i = 0; i < count; ++i)
        records.push_back(near[i].second->record);
    return records;
}

void FileGroups::link(const std::string& a, const std::string& b) {
    near_[a].insert(b);
    near_[b].insert(a);
    touched_.insert(a);
}

void FileGroups::join_live_pairs(const RecordList::Record& record) {
    for (const std::string& name : live_names(*record)) {
        std::set<std::string>& paths = by_name_[name];
        for (const std::string& path : paths) {
            const RecordList::Record other = files_.find(path);
            if (!other || !(are_live_pair(*record, *other) || are_live_pair(*other, *record))) continue;
            live_[record->path].insert(path);
            live_[path].insert(record->path);
            touched_.insert(path);
        }
        paths.insert(record->path);
    }
}

/// The file and all that it is one with.
std::set<std::string> FileGroups::connected(const std::string& path) const {
    std::set<std::string> found;
    std::vector<std::string> waiting{path};
    while (!waiting.empty()) {
        const std::string next = std::move(waiting.back());
        waiting.pop_back();
        if (!found.insert(next).second) continue;
        for (const auto* links : {&near_, &live_})
            if (const auto near = links->find(next); near != links->end())
                waiting.insert(waiting.end(), near->second.begin(), near->second.end());
    }
    return found;
}

/// True where the photo may stand in for the best one of its group.
bool FileGroups::is_near(const RecordList::Record& best, const RecordList::Record& photo) {
    const auto linked = near_.find(best->path);
    if (linked != near_.end() && linked->second.contains(photo->path)) return true;
    const auto key = std::minmax(best->path, photo->path);
    const auto known = compared_.find(key);
    if (known != compared_.end()) return known->second;
    return compared_[key] = are_near_copies(*best, *photo);
}

/// Parts photos that are linked somehow: the best has with it those that are near to itself, and so on with
/// the others. So pictures that change slowly do not become one by a chain.
/// @param photos  the best first
std::vector<FileGroup> FileGroups::groups_among(std::vector<RecordList::Record> photos) {
    std::vector<FileGroup> groups;
    while (!photos.empty()) {
        const RecordList::Record best = photos.front();
        const auto others = std::stable_partition(photos.begin(), photos.end(), [&](const auto& photo) {
            return photo == best || is_near(best, photo);
        });
        FileGroup& group = groups.emplace_back();
        for (auto member = photos.begin(); member != others; ++member) {
            group.photos.push_back((*member)->path);
            if (const auto film = live_.find((*member)->path); film != live_.end() && !film->second.empty())
                group.films[(*member)->path] = *film->second.begin();
        }
        photos.erase(photos.begin(), others);
    }
    return groups;
}

/// Gives these files their groups anew.
void FileGroups::regroup(const std::set<std::string>& paths, GroupList::Changes& changes) {
    std::vector<RecordList::Record> photos;
    for (const std::string& path : paths) {
        changes[path] = nullptr;
        const RecordList::Record record = files_.find(path);
        if (record && record->kind == MediaKind::photo) photos.push_back(record);
    }
    std::ranges::sort(photos, is_better);
    for (FileGroup& found : groups_among(std::move(photos))) {
        if (found.photos.size() + found.films.size() < 2) continue;
        const auto group = std::make_shared<const FileGroup>(std::move(found));
        const auto add = [&](const std::string& path) {
            changes[path] = std::make_shared<const GroupedFile>(GroupedFile{.path = path, .group = group});
        };
        std::ranges::for_each(group->photos, add);
        for (const std::string& photo : group->photos)
            if (const auto films = live_.find(photo); films != live_.end())
                std::ranges::for_each(films->second, add);
    }
}

void FileGroups::regroup_touched() {
    GroupList::Changes changes;
    for (const std::string& path : touched_)
        if (!changes.contains(path)) regroup(connected(path), changes);
    groups_.apply(changes);
    touched_.clear();
}

}  // namespace vitrine::player
