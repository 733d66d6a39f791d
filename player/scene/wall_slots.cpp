#include "player/scene/wall_slots.hpp"

#include <algorithm>
#include <utility>

namespace vitrine::player {

namespace {

constexpr std::chrono::milliseconds first_leaves{2500};  // of the shots of a film that came at once
constexpr std::chrono::seconds short_shot{1};            // a shorter one of several plays once and gives way

/// A time at which a shot could leave, and the length of its loop: 0 for a shot that leaves at any time.
struct Leaving {
    std::chrono::nanoseconds due;
    std::chrono::nanoseconds loop;
};

/// The time at which a shot leaves. A film that stays longer than its time leaves at the end of a loop,
/// unless that would delay the next change by more than `spacing`.
std::chrono::nanoseconds leaving_time(const Leaving& leaving, std::chrono::nanoseconds earliest,
                                      std::chrono::nanoseconds spacing) {
    const auto [due, loop] = leaving;
    if (earliest <= due) return due;
    if (loop.count() <= 0) return earliest;
    const auto loops = (earliest - due + loop - std::chrono::nanoseconds(1)) / loop;
    const std::chrono::nanoseconds seam = due + loops * loop;
    return seam - earliest <= spacing ? seam : earliest;
}

/// The rules for the time that a shot stays.
struct StayRules {
    const SlotSettings& settings;
    const ShowHints& hints;
    const RecordList& files;
    long count = 1;  // shots of its file on the wall
};

/// The time that a shot stays: as its hints say; else a film stays for whole loops, unless they take too
/// long, and for one loop if that is a very short one of several, or if it is in sequence beside its film's
/// other shots.
std::chrono::nanoseconds time_to_stay(const WallShot& shot, const StayRules& rules) {
    const auto said = rules.hints.find(shot.key.path);
    if (said && said->hints.dwell) return *said->hints.dwell;
    if (shot.kind == MediaKind::photo) return rules.settings.dwell;
    const std::chrono::nanoseconds loop = shot.shot.duration();
    if (loop < short_shot && rules.files.find(shot.key.path)->shots.size() > 1) return loop;
    const std::chrono::nanoseconds max_dwell = rules.settings.max_dwell;
    if (is_in_sequence(rules.settings.film, rules.files.size()) && rules.count > 1)
        return std::min(loop, max_dwell);
    const auto loops = (rules.settings.dwell + loop - std::chrono::nanoseconds(1)) / loop;
    return std::min(loop * std::max<std::int64_t>(1, loops), std::max(rules.settings.dwell, max_dwell));
}

}  // namespace

WallSlots::WallSlots(const SlotSettings& settings)
    : settings_(settings),
      chooser_(settings.order, settings.seed, settings.film),
      slots_(static_cast<std::size_t>(std::max(1, settings.count))),
      numbers_(settings.numbers ? settings.numbers : std::make_shared<SourceId>(settings.last_source)) {}

void WallSlots::set_catalogue(const RecordList& records, const ShowHints& hints) {
    hints_ = hints;
    const RecordList before = files_.all();
    files_.set(records);
    chooser_.set_files(files_.all(), before, hints_);
    follow_changes(before);
    fill_slots();
}

void WallSlots::follow_changes(const RecordList& before) {
    for (Slot& slot : slots_) {
        if (!slot.shot) continue;
        const ShotKey key = slot.shot->key;
        const RecordList::Record file = files_.all().find(key.path);
        if (!file || key.shot >= static_cast<int>(file->shots.size())) {
            slot = {};
        } else if (!is_grown_from(*file, *before.find(key.path))) {
            put_shot(slot, key);
            due_.reset();
        } else {
            slot.shot->shot = shot_now(*file, *slot.shot);  // the store may have it by now
        }
    }
    // Files that have turned out to be one with another on the wall leave; a pinned one stays.
    std::map<std::string, Slot*> seen;
    for (Slot& slot : slots_) {
        if (!slot.shot || slot.shot->key.shot > 0) continue;
        const std::string& path = slot.shot->key.path;
        const auto [first, is_new] = seen.emplace(chooser_.groups().head_of(path), &slot);
        if (is_new || first->second->shot->key.path == path) continue;
        const bool is_last_pinned = is_pinned(slot) && !is_pinned(*first->second);
        Slot& freed = is_last_pinned ? *first->second : slot;
        if (is_last_pinned) first->second = &slot;
        if (!is_pinned(freed)) freed = {};
    }
}

void WallSlots::set_controls(const ShowControls& controls) {
    if (controls.files != controls_.files) next_turn_ = {};
    std::shared_ptr<const ArrangedWall> awaited = std::move(controls_.arranged);
    controls_ = controls;
    if (!controls.arranged) {
        controls_.arranged = std::move(awaited);
        return;
    }
    due_.reset();
    const std::vector<Slot> before = std::exchange(slots_, std::vector<Slot>(slots_.size()));
    for (std::size_t i = 0; i < slots_.size(); ++i) {
        const auto key = arranged_key(*controls.arranged, static_cast<int>(i));
        const auto has_key = [&](const Slot& slot) { return key && slot.shot && slot.shot->key == *key; };
        const auto same = std::ranges::find_if(before, has_key);
        if (same == before.end() || std::ranges::any_of(slots_, has_key)) continue;
        slots_[i] = *same;
        slots_[i].shot->slot = static_cast<int>(i);
    }
    fill_slots();
}

/// Gives free slots the shots that the arrangement has there. It is done with once there are files.
void WallSlots::fill_arranged() {
    if (!controls_.arranged || files_.all().is_empty()) return;
    const std::shared_ptr<const ArrangedWall> arranged = std::exchange(controls_.arranged, nullptr);
    for (std::size_t i = 0; i < slots_.size(); ++i) {
        const auto key = arranged_key(*arranged, static_cast<int>(i));
        if (slots_[i].shot || !key || chooser_.is_avoided(key->path)) continue;
        const RecordList::Record file = files_.all().find(key->path);
        const auto has_key = [&](const Slot& slot) { return slot.shot && slot.shot->key == *key; };
        if (!file || key->shot >= static_cast<int>(file->shots.size())) continue;
        if (std::ranges::any_of(slots_, has_key)) continue;
        slots_[i].then = *key;  // a Live Photo comes without its film
        put_shot(slots_[i], *key);
    }
}

bool WallSlots::is_pinned(const Slot& slot) const {
    return slot.shot &&
           (controls_.slots.contains(slot.shot->slot) || controls_.files.contains(slot.shot->key.path));
}

const std::string* WallSlots::pinned_and_missing() const {
    const auto found =
        std::find_if(controls_.files.begin(), controls_.files.end(), [&](const std::string& path) {
            return files_.all().contains(path) && !chooser_.is_avoided(path) && count_on_wall(path) == 0;
        });
    return found == controls_.files.end() ? nullptr : &*found;
}

void WallSlots::advance(std::chrono::nanoseconds now) {
    if (chooser_.end_avoidance(now)) fill_slots();
    const bool is_asked = turns_taken_ < controls_.turns;
    const bool is_missing = pinned_and_missing() != nullptr;
    if (!is_asked && (now < next_turn_ || (controls_.is_paused && !is_missing))) return;
    const bool is_at_once = is_asked || is_missing;
    turns_taken_ = controls_.turns;
    const std::vector<Turn> next =
        due_turns(is_at_once ? std::chrono::nanoseconds::max() : now + settings_.lead);
    for (const Turn& turn : next) {
        const auto key = choose_shot(*turn.slot);
        if (!key) continue;
        put_shot(*turn.slot, *key);
        due_ = is_at_once ? now
                          : leaving_time({.due = turn.due, .loop = turn.loop},
                                         std::max(now, last_due_ + settings_.spacing), settings_.spacing);
        last_due_ = *due_;
        next_turn_ = *due_ + settings_.spacing - settings_.lead;
        return;
    }
    if (!next.empty()) next_turn_ = now + std::chrono::seconds(1);  // all shots are on the wall already
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
    if (at->then == at->shot->key) return put_shot(*at, at->shot->key);  // the photo without its film
    chooser_.avoid_file(path, now + settings_.retry_after);
    for (Slot& slot : slots_) {
        if (!slot.shot || slot.shot->key.path != path) continue;
        const std::optional<ShotKey> photo = slot.then;
        slot = {};
        if (photo) put_shot(slot, *photo);
    }
    fill_slots();
}

void WallSlots::dismiss_shot(SourceId source, std::chrono::nanoseconds now) {
    const auto at = std::find_if(slots_.begin(), slots_.end(),
                                 [&](const Slot& slot) { return slot.shot && slot.shot->source == source; });
    if (at == slots_.end()) return;
    due_.reset();
    at->then.reset();
    if (const auto key = choose_shot(*at)) return put_shot(*at, *key);
    chooser_.avoid_file(at->shot->key.path, now + settings_.retry_after);
    *at = {};
}

std::vector<WallShot> WallSlots::shots() const {
    std::vector<WallShot> shots;
    for (const Slot& slot : slots_) {
        if (slot.shot) shots.push_back(*slot.shot);
    }
    return shots;
}

void WallSlots::fill_slots() {
    fill_arranged();
    std::vector<Slot*> filled;
    for (Slot& slot : slots_) {
        if (slot.shot) continue;
        due_.reset();
        const auto key = choose_shot(slot);
        if (!key) break;
        put_shot(slot, *key);
        filled.push_back(&slot);
    }
    spread_leaving(filled);
}

/// Makes shots of one film that came at once in sequence leave one after the other, evenly spread over their
/// time; the first leaves soon. Source: Dynamic Media Assemblage, chapter 4, "sequentially with time
/// overlaps"; docs/algorithms.md, (d).
void WallSlots::spread_leaving(const std::vector<Slot*>& filled) {
    if (!is_in_sequence(settings_.film, files_.all().size())) return;
    std::map<std::string, std::vector<Slot*>> films;
    for (Slot* slot : filled)
        if (slot->shot->kind == MediaKind::film && !slot->then) films[slot->shot->key.path].push_back(slot);
    for (const auto& [path, slots] : films) {
        const auto count = static_cast<std::int64_t>(slots.size());
        for (std::int64_t k = 0; k < count; ++k) {
            Slot& slot = *slots[static_cast<std::size_t>(k)];
            const std::chrono::nanoseconds stay = time_to_stay(
                *slot.shot, {settings_, hints_, files_.all(), count_on_wall(slot.shot->key.path)});
            const std::chrono::nanoseconds first =
                count > 1 ? std::min<std::chrono::nanoseconds>(stay / count, first_leaves) : stay;
            slot.ahead = stay - first - stay * k / count;
        }
    }
}

/// The slots whose shots will have had their time at `until`, the longest overdue first.
std::vector<WallSlots::Turn> WallSlots::due_turns(std::chrono::nanoseconds until) {
    std::vector<Turn> turns;
    for (Slot& slot : slots_) {
        if (!slot.shot || !slot.shown || (is_pinned(slot) && !slot.then)) continue;
        const std::chrono::nanoseconds stay =
            slot.then ? slot.shot->shot.duration()
                      : time_to_stay(*slot.shot,
                                     {settings_, hints_, files_.all(), count_on_wall(slot.shot->key.path)});
        const std::chrono::nanoseconds due = *slot.shown + stay - slot.ahead;
        if (due > until) continue;
        const std::chrono::nanoseconds loop = slot.shot->shot.duration();
        const bool is_seam = slot.shot->kind == MediaKind::film && loop.count() > 0 &&
                             (due - *slot.shown).count() % loop.count() == 0;
        turns.push_back({&slot, due, is_seam ? loop : std::chrono::nanoseconds(0)});
    }
    std::stable_sort(turns.begin(), turns.end(), [](const Turn& a, const Turn& b) { return a.due < b.due; });
    return turns;
}

std::optional<ShotKey> WallSlots::choose_shot(const Slot& slot) {
    if (slot.then && files_.all().contains(slot.then->path) && !chooser_.is_avoided(slot.then->path))
        return slot.then;
    FreeSlot free{.on_wall = {},
                  .leaving = slot.shot ? slot.shot->key.path : std::string(),
                  .slots = slots_.size(),
                  .pinned = pinned_and_missing()};
    for (const Slot& other : slots_)
        if (other.shot) free.on_wall.push_back(other.shot->key);
    return chooser_.next_shot(free);
}

/// Puts a shot into a slot, or the film that belongs to it before it.
void WallSlots::put_shot(Slot& slot, const ShotKey& key) {
    const bool is_film_over = slot.then == key;
    const bool is_same = slot.shot && slot.shot->key == key;  // it is loaded again
    const auto film = film_of_photo(files_.all(), chooser_.groups(), key);
    const bool plays_film = film && !is_film_over && !chooser_.is_avoided(film->key.path);
    if (plays_film)
        slot.then = key;
    else if (!is_same || is_film_over)
        slot.then.reset();
    slot.shown.reset();
    slot.ahead = {};
    slot.shot = plays_film ? *film : wall_shot(*files_.all().find(key.path), key, 0, 0);
    if (!plays_film) slot.shot->film = film;
    slot.shot->source = ++*numbers_;
    slot.shot->slot = static_cast<int>(&slot - slots_.data());
}

long WallSlots::count_on_wall(const std::string& path) const {
    return std::count_if(slots_.begin(), slots_.end(), [&](const Slot& slot) {
        return slot.shot && (slot.shot->key.path == path || (slot.then && slot.then->path == path));
    });
}

}  // namespace vitrine::player
