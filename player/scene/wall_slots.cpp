#include "player/scene/wall_slots.hpp"

#include <algorithm>

namespace vitrine::player {

namespace {

bool can_be_shown(const MediaRecord& record) {
    if (record.state != MediaState::ready || record.width <= 0 || record.height <= 0) return false;
    if (record.shots.empty()) return false;
    return record.kind == MediaKind::photo ||
           std::all_of(record.shots.begin(), record.shots.end(),
                       [](const Shot& shot) { return shot.duration().count() > 0; });
}

}  // namespace

WallSlots::WallSlots(const SlotSettings& settings)
    : settings_(settings),
      rotation_(settings.order, settings.seed),
      slots_(static_cast<std::size_t>(std::max(1, settings.count))),
      last_source_(settings.last_source) {}

void WallSlots::set_catalogue(const RecordList& records, const ShowHints& hints) {
    hints_ = hints;
    std::map<std::string, RecordList::Record> files;
    for (const RecordList::Record& record : records)
        if (can_be_shown(*record)) files.emplace(record->path, record);
    std::erase_if(avoided_, [&](const auto& avoided) {
        const auto before = files_.find(avoided.first);
        const auto after = files.find(avoided.first);
        return before == files_.end() || after == files.end() ||
               !is_grown_from(*after->second, *before->second);
    });
    files_.swap(files);  // `files` is what was known before, from here on
    std::vector<const MediaRecord*> known;
    for (const auto& [path, record] : files_)
        known.push_back(record.get());
    rotation_.set_files(known, hints_);
    follow_changes(files);
    fill();
}

void WallSlots::follow_changes(const std::map<std::string, RecordList::Record>& before) {
    for (Slot& slot : slots_) {
        if (!slot.shot) continue;
        const ShotKey key = slot.shot->key;
        const auto found = files_.find(key.path);
        if (found == files_.end() || key.shot >= static_cast<int>(found->second->shots.size())) {
            slot = {};
        } else if (!is_grown_from(*found->second, *before.at(key.path))) {
            put(slot, key);
            due_.reset();
        } else {
            slot.shot->shot =
                found->second->shots[static_cast<std::size_t>(key.shot)];  // the store may have it now
        }
    }
}

void WallSlots::set_controls(const ShowControls& controls) {
    if (controls.files != controls_.files) next_turn_ = {};
    controls_ = controls;
}

bool WallSlots::is_pinned(const Slot& slot) const {
    return slot.shot &&
           (controls_.slots.contains(slot.shot->slot) || controls_.files.contains(slot.shot->key.path));
}

const std::string* WallSlots::pinned_and_missing() const {
    const auto found =
        std::find_if(controls_.files.begin(), controls_.files.end(), [&](const std::string& path) {
            return files_.contains(path) && !avoided_.contains(path) && count_on_wall(path) == 0;
        });
    return found == controls_.files.end() ? nullptr : &*found;
}

/// Its next shot, also where it is not its turn.
std::optional<ShotKey> WallSlots::take_pinned(const std::string& path) {
    const auto fits = [&](const ShotKey& key) { return key.path == path; };
    if (auto key = rotation_.next_shot(fits)) return key;
    rotation_.restart_finished([&](const ShotKey& key) { return is_on_wall(key); }, path);
    return rotation_.next_shot(fits);
}

void WallSlots::advance(std::chrono::nanoseconds now) {
    if (std::erase_if(avoided_, [&](const auto& avoided) { return avoided.second <= now; }) > 0) fill();
    const bool is_asked = turns_taken_ < controls_.turns;
    const bool is_missing = pinned_and_missing() != nullptr;
    if (!is_asked && (now < next_turn_ || (controls_.is_paused && !is_missing))) return;
    const bool is_at_once = is_asked || is_missing;
    turns_taken_ = controls_.turns;
    const std::vector<Turn> next = turns(is_at_once ? std::chrono::nanoseconds::max() : now + settings_.lead);
    for (const Turn& turn : next) {
        const auto key = next_for(*turn.slot);
        if (!key) continue;
        put(*turn.slot, *key);
        due_ = is_at_once ? now : leaves(turn, std::max(now, last_due_ + settings_.spacing));
        last_due_ = *due_;
        next_turn_ = *due_ + settings_.spacing - settings_.lead;
        return;
    }
    if (!next.empty()) next_turn_ = now + std::chrono::seconds(1);  // all that there is is on the wall
}

/// A film that has to stay longer than its time leaves at the end of a loop, where that does not hold up the
/// next change.
std::chrono::nanoseconds WallSlots::leaves(const Turn& turn, std::chrono::nanoseconds earliest) const {
    if (earliest <= turn.due) return turn.due;
    if (turn.loop.count() <= 0) return earliest;
    const auto loops = (earliest - turn.due + turn.loop - std::chrono::nanoseconds(1)) / turn.loop;
    const std::chrono::nanoseconds seam = turn.due + loops * turn.loop;
    return seam - earliest <= settings_.spacing ? seam : earliest;
}

void WallSlots::shot_appeared(SourceId source, std::chrono::nanoseconds now) {
    for (Slot& slot : slots_) {
        if (slot.shot && slot.shot->source == source && !slot.shown) slot.shown = now;
    }
}

void WallSlots::source_failed(SourceId source, std::chrono::nanoseconds now) {
    const auto at = std::find_if(slots_.begin(), slots_.end(),
                                 [&](const Slot& slot) { return slot.shot && slot.shot->source == source; });
    if (at == slots_.end()) return;
    const std::string path = at->shot->key.path;
    avoided_[path] = now + settings_.retry_after;
    for (Slot& slot : slots_) {
        if (slot.shot && slot.shot->key.path == path) slot = {};
    }
    fill();
}

void WallSlots::dismiss_shot(SourceId source, std::chrono::nanoseconds now) {
    const auto at = std::find_if(slots_.begin(), slots_.end(),
                                 [&](const Slot& slot) { return slot.shot && slot.shot->source == source; });
    if (at == slots_.end()) return;
    due_.reset();
    if (const auto key = next_for(*at)) return put(*at, *key);
    avoided_[at->shot->key.path] = now + settings_.retry_after;
    *at = {};
}

std::vector<WallShot> WallSlots::shots() const {
    std::vector<WallShot> shots;
    for (const Slot& slot : slots_) {
        if (slot.shot) shots.push_back(*slot.shot);
    }
    return shots;
}

void WallSlots::fill() {
    std::vector<Slot*> filled;
    for (Slot& slot : slots_) {
        if (slot.shot) continue;
        due_.reset();
        const auto key = next_for(slot);
        if (!key) break;
        put(slot, *key);
        filled.push_back(&slot);
    }
    spread(filled);
}

/// Shots of one film in sequence that come at once leave one after the other, evenly spread over their time.
/// Source: Dynamic Media Assemblage, chapter 4, "sequentially with time overlaps"; ALGORITHMS (d).
void WallSlots::spread(const std::vector<Slot*>& filled) {
    if (settings_.film != FilmShow::sequence) return;
    std::map<std::string, std::vector<Slot*>> films;
    for (Slot* slot : filled)
        if (slot->shot->kind == MediaKind::film) films[slot->shot->key.path].push_back(slot);
    for (const auto& [path, slots] : films) {
        const auto count = static_cast<std::int64_t>(slots.size());
        for (std::int64_t k = 0; k < count; ++k) {
            Slot& slot = *slots[static_cast<std::size_t>(k)];
            slot.ahead = stay(*slot.shot) * (count - 1 - k) / count;
        }
    }
}

/// The slots whose shots will have had their time until then, the longest overdue first.
std::vector<WallSlots::Turn> WallSlots::turns(std::chrono::nanoseconds until) {
    std::vector<Turn> turns;
    for (Slot& slot : slots_) {
        if (!slot.shot || !slot.shown || is_pinned(slot)) continue;
        const std::chrono::nanoseconds due = *slot.shown + stay(*slot.shot) - slot.ahead;
        if (due > until) continue;
        const std::chrono::nanoseconds loop = slot.shot->shot.duration();
        const bool is_seam = slot.shot->kind == MediaKind::film && loop.count() > 0 &&
                             (due - *slot.shown).count() % loop.count() == 0;
        turns.push_back({&slot, due, is_seam ? loop : std::chrono::nanoseconds(0)});
    }
    std::stable_sort(turns.begin(), turns.end(), [](const Turn& a, const Turn& b) { return a.due < b.due; });
    return turns;
}

/// So long as the operator says. Else films leave at the end of a loop, unless that is too long; those in
/// sequence beside other shots of their own after one.
std::chrono::nanoseconds WallSlots::stay(const WallShot& shot) const {
    const auto hints = hints_.find(shot.key.path);
    if (hints != hints_.end() && hints->second.dwell) return *hints->second.dwell;
    if (shot.kind == MediaKind::photo) return settings_.dwell;
    const std::chrono::nanoseconds loop = shot.shot.duration();
    if (settings_.film == FilmShow::sequence && count_on_wall(shot.key.path) > 1)
        return std::min(loop, settings_.max_dwell);
    const auto loops = (settings_.dwell + loop - std::chrono::nanoseconds(1)) / loop;
    const std::chrono::nanoseconds max_dwell = std::max(settings_.dwell, settings_.max_dwell);
    return std::min(loop * std::max<std::int64_t>(1, loops), max_dwell);
}

std::optional<ShotKey> WallSlots::next_for(const Slot& slot) {
    if (const std::string* pinned = pinned_and_missing())
        if (auto key = take_pinned(*pinned)) return key;
    const std::string present = slot.shot ? slot.shot->key.path : std::string();
    const auto is_free = [&](const ShotKey& key) { return !avoided_.contains(key.path) && !is_on_wall(key); };
    const auto stands_alone = [&](const ShotKey& key) {
        return is_free(key) && count_on_wall(key.path) == (key.path == present ? 1 : 0);
    };
    // Rather side by side with its own film than a free place, but not instead of another file's only shot,
    // unless the files take turns anyway and no shot may come again yet.
    const bool can_double = present.empty() || count_on_wall(present) > 1;
    const bool is_strict = settings_.film == FilmShow::side_by_side;
    const bool takes_turns = files_.size() > slots_.size();
    const auto stands = [&](const ShotKey& key) { return is_on_wall(key); };
    if (auto key = rotation_.next_shot(stands_alone)) return key;
    if (is_strict && (can_double || takes_turns))
        if (auto key = rotation_.next_shot(is_free)) return key;
    if (is_strict && !rotation_.has_shot(is_free))
        rotation_.restart_all(stands);
    else
        rotation_.restart_finished(stands, is_strict ? present : "");
    if (auto key = rotation_.next_shot(stands_alone)) return key;
    return can_double ? rotation_.next_shot(is_free) : std::nullopt;
}

void WallSlots::put(Slot& slot, const ShotKey& key) {
    slot.shown.reset();
    slot.ahead = {};
    slot.shot = wall_shot(*files_.at(key.path), key, ++last_source_, static_cast<int>(&slot - slots_.data()));
}

bool WallSlots::is_on_wall(const ShotKey& key) const {
    return std::any_of(slots_.begin(), slots_.end(),
                       [&](const Slot& slot) { return slot.shot && slot.shot->key == key; });
}

long WallSlots::count_on_wall(const std::string& path) const {
    return std::count_if(slots_.begin(), slots_.end(),
                         [&](const Slot& slot) { return slot.shot && slot.shot->key.path == path; });
}

}  // namespace vitrine::player
