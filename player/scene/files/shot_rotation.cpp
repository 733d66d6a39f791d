#include "player/scene/files/shot_rotation.hpp"

#include "base/calendar/dates.hpp"

#include <algorithm>
#include <functional>
#include <utility>

namespace vitrine::player {

namespace {

int shots_of(const RecordList::Record& record) {
    return record ? static_cast<int>(record->shots.size()) : 0;
}

std::int64_t taken_ns(const MediaRecord& record) {
    if (!record.origin.taken) return record.mtime_ns;
    return std::chrono::nanoseconds(record.origin.taken->at.time_since_epoch()).count();
}

int repeat_of(const ShowHints::Entry& said) {
    return said ? said->hints.repeat.value_or(1) : 1;
}

}  // namespace

void ShotRotation::set_files(const RecordList& files, const ShowHints& hints) {
    std::set<std::string> shrunk;
    std::vector<ShotKey> first;
    std::vector<ShotKey> later;
    Turns taken;
    files.for_each_change(records_, [&](const RecordList::Record& before, const RecordList::Record& now) {
        const std::string& path = (now ? now : before)->path;
        if (shots_of(now) < shots_of(before)) shrunk.insert(path);
        if (!now) {
            files_.erase(path);
            return;
        }
        const int repeat = repeat_of(hints.find(path));
        files_[path] = {.mtime_ns = now->mtime_ns,
                        .taken_ns = taken_ns(*now),
                        .day = now->origin.day_of_camera(),
                        .shots = shots_of(now),
                        .repeat = repeat};
        for (int shot = shots_of(before); shot < shots_of(now); ++shot) {
            if (shot == 0) first.push_back({path, shot});
            if (shot == 0) taken[{path, shot}] = 1;
            if (shot > 0 || repeat > 1) later.push_back({path, shot});
        }
    });
    hints.for_each_change(hints_, [&](const ShowHints::Entry& before, const ShowHints::Entry& now) {
        const auto file = files_.find((now ? now : before)->path);
        if (file != files_.end()) file->second.repeat = repeat_of(now);
    });
    records_ = files;
    const bool is_other_day = hints.today != hints_.today;
    hints_ = hints;
    drop_lost_turns(shrunk);
    if (is_other_day)
        std::stable_partition(waiting_.begin(), waiting_.end(),
                              [&](const ShotKey& key) { return is_anniversary(key); });
    first = ordered(std::move(first));
    later = repeated(ordered(std::move(later)), taken);
    waiting_.insert(waiting_.begin(), first.begin(), first.end());
    waiting_.insert(waiting_.end(), later.begin(), later.end());
}

/// @param files  files that are gone, or have fewer shots than before
void ShotRotation::drop_lost_turns(const std::set<std::string>& files) {
    if (files.empty()) return;
    std::erase_if(waiting_, [&](const ShotKey& key) {
        if (!files.contains(key.path)) return false;
        const auto found = files_.find(key.path);
        return found == files_.end() || key.shot >= found->second.shots;
    });
}

std::optional<ShotKey> ShotRotation::next_shot(const Fits& fits) {
    const auto found = std::find_if(waiting_.begin(), waiting_.end(), fits);
    if (found == waiting_.end()) return std::nullopt;
    ShotKey key = std::move(*found);
    waiting_.erase(found);
    return key;
}

void ShotRotation::restart_finished(const Fits& is_on_wall, const std::string& only) {
    std::set<std::string> unfinished;
    for (const ShotKey& key : waiting_)
        unfinished.insert(key.path);
    std::vector<ShotKey> again;
    for (const auto& [path, file] : files_) {
        if (unfinished.contains(path) || (!only.empty() && path != only)) continue;
        for (int shot = 0; shot < file.shots; ++shot)
            again.push_back({path, shot});
    }
    append(std::move(again), is_on_wall);
}

void ShotRotation::restart_all(const Fits& is_on_wall) {
    Turns left;
    for (const ShotKey& key : waiting_)
        ++left[key];
    std::vector<ShotKey> again;
    for (const auto& [path, file] : files_)
        for (int shot = 0; shot < file.shots; ++shot)
            if (!left.contains({path, shot}) || file.repeat > 1) again.push_back({path, shot});
    append(std::move(again), is_on_wall, left);
}

void ShotRotation::append(std::vector<ShotKey> again, const Fits& is_on_wall, const Turns& left) {
    again = ordered(std::move(again));
    std::stable_partition(again.begin(), again.end(), [&](const ShotKey& key) { return !is_on_wall(key); });
    again = repeated(again, left);
    waiting_.insert(waiting_.end(), again.begin(), again.end());
}

/// A round in which each shot has as many turns as its file's frequency says. Its turns are spread over the
/// round, starting at the shot's place in the order.
/// @param left  the turns that each shot still has
std::vector<ShotKey> ShotRotation::repeated(const std::vector<ShotKey>& keys, const Turns& left) const {
    std::vector<std::pair<double, const ShotKey*>> places;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const auto has = left.find(keys[i]);
        const int turns = files_.at(keys[i].path).repeat - (has == left.end() ? 0 : has->second);
        const double place = static_cast<double>(i) / static_cast<double>(keys.size());
        for (int turn = 0; turn < turns; ++turn)
            places.emplace_back((place + turn) / turns, &keys[i]);
    }
    std::stable_sort(places.begin(), places.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<ShotKey> round;
    round.reserve(places.size());
    for (const auto& [place, key] : places)
        round.push_back(*key);
    return round;
}

std::vector<ShotKey> ShotRotation::ordered(std::vector<ShotKey> keys) {
    std::sort(keys.begin(), keys.end());
    if (order_ == ShotOrder::newest) {
        std::stable_sort(keys.begin(), keys.end(), [&](const ShotKey& a, const ShotKey& b) {
            return files_.at(a.path).mtime_ns > files_.at(b.path).mtime_ns;
        });
    } else if (order_ == ShotOrder::taken) {
        std::stable_sort(keys.begin(), keys.end(), [&](const ShotKey& a, const ShotKey& b) {
            return files_.at(a.path).taken_ns < files_.at(b.path).taken_ns;
        });
    } else if (order_ == ShotOrder::shuffle) {
        std::shuffle(keys.begin(), keys.end(), engine_);
        keep_time_order(keys);
    }
    if (hints_.today)
        std::stable_partition(keys.begin(), keys.end(),
                              [&](const ShotKey& key) { return is_anniversary(key); });
    return keys;
}

/// True for a shot that was taken on this day in another year.
bool ShotRotation::is_anniversary(const ShotKey& key) const {
    const auto file = files_.find(key.path);
    if (!hints_.today || file == files_.end() || !file->second.day) return false;
    return vitrine::is_anniversary(*file->second.day, *hints_.today);
}

/// Each file keeps the places that it drew, but fills them in time order.
void ShotRotation::keep_time_order(std::vector<ShotKey>& keys) const {
    std::map<std::string, std::vector<int>> shots;
    for (const ShotKey& key : keys)
        shots[key.path].push_back(key.shot);
    for (auto& [path, indices] : shots)
        std::sort(indices.begin(), indices.end(), std::greater<>());
    for (ShotKey& key : keys) {
        std::vector<int>& left = shots.at(key.path);
        key.shot = left.back();
        left.pop_back();
    }
}

}  // namespace vitrine::player
