#include "player/scene/files/group_turns.hpp"

#include <algorithm>
#include <set>

namespace vitrine::player {

void GroupTurns::set_files(const RecordList& files, const ShowHints& hints) {
    std::set<std::string> changed;
    files.for_each_change(files_, [&](const RecordList::Record& before, const RecordList::Record& now) {
        changed.insert((now ? now : before)->path);
    });
    const auto add_group = [&](const GroupList& groups, const std::string& path) {
        if (const GroupList::Entry entry = groups.find(path))
            changed.insert(entry->group->photos.begin(), entry->group->photos.end());
    };
    hints.groups.for_each_change(groups_, [&](const GroupList::Entry& before, const GroupList::Entry& now) {
        changed.insert((now ? now : before)->path);
    });
    for (const std::string& path : std::set<std::string>(changed)) {
        add_group(groups_, path);
        add_group(hints.groups, path);
    }
    files_ = files;
    groups_ = hints.groups;
    RecordList::Changes changes;
    for (const std::string& path : changed) {
        const RecordList::Record record = files_.find(path);
        changes[path] = record && head_now(path) == path ? record : nullptr;
        if (!changes[path]) next_.erase(path);
    }
    heads_.apply(changes);
}

/// The photos of its group that may be shown, the best first; the file alone where it has no group.
std::vector<std::string> GroupTurns::members(const std::string& path) const {
    const GroupList::Entry entry = groups_.find(path);
    std::vector<std::string> found;
    if (entry)
        for (const std::string& photo : entry->group->photos)
            if (files_.contains(photo)) found.push_back(photo);
    if (found.empty()) found.push_back(path);
    return found;
}

std::string GroupTurns::head_now(const std::string& path) const {
    return members(path).front();
}

std::string GroupTurns::head_of(const std::string& path) const {
    return groups_.contains(path) ? head_now(path) : path;
}

bool GroupTurns::has_others(const std::string& path, const Fits& fits) const {
    return std::ranges::any_of(members(path),
                               [&](const std::string& member) { return member != path && fits(member); });
}

bool GroupTurns::has_turn(const std::string& head, const Fits& fits) const {
    return groups_.contains(head) ? std::ranges::any_of(members(head), fits) : fits(head);
}

std::optional<std::string> GroupTurns::take_turn(const std::string& head, const Fits& fits) {
    if (!groups_.contains(head)) return fits(head) ? std::optional(head) : std::nullopt;
    const std::vector<std::string> photos = members(head);
    std::size_t& next = next_[head];
    for (std::size_t i = 0; i < photos.size(); ++i) {
        const std::size_t number = (next + i) % photos.size();
        if (!fits(photos[number])) continue;
        next = number + 1;
        return photos[number];
    }
    return std::nullopt;
}

std::string GroupTurns::film_of(const std::string& photo) const {
    const GroupList::Entry entry = groups_.find(photo);
    if (!entry) return {};
    const auto film = entry->group->films.find(photo);
    return film != entry->group->films.end() && files_.contains(film->second) ? film->second : std::string();
}

}  // namespace vitrine::player
