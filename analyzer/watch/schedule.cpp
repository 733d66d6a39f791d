#include "analyzer/watch/schedule.hpp"

#include "base/hints/notice.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

namespace vitrine::analyzer {

using std::chrono::nanoseconds;

namespace {

/// Files with larger numbers are analysed first: those of notices, then the newest.
std::int64_t turn_of(const std::string& path, const FileFacts& facts) {
    return notice_named(path) ? std::numeric_limits<std::int64_t>::max() : facts.mtime_ns;
}

}  // namespace

Schedule::Schedule(const Pace& pace) : pace_(pace) {
    assert(pace.children >= 1);
}

void Schedule::add_recorded(const std::string& path, const FileFacts& facts, bool is_settled, bool is_held) {
    Entry& entry = entries_[path];
    entry.facts = facts;
    entry.phase = is_settled ? Phase::unseen : Phase::stale;
    entry.recorded = is_held ? Recorded::waiting : Recorded::yes;
}

void Schedule::see_file(const std::string& path, const FileFacts& facts, Time now, LookKind look) {
    const nanoseconds delay = pace_.quiet_after(look);
    const auto found = entries_.find(path);
    if (found == entries_.end()) return see_new_file(path, facts, look, now);
    Entry& entry = found->second;
    entry.is_remote = look == LookKind::remote;
    const bool is_same =
        is_same_content(entry.facts, facts) && (entry.is_remote || is_same_file(entry.facts, facts));
    switch (entry.phase) {
    case Phase::stale:
        return see_change(path, entry, facts, delay, now);
    case Phase::unseen:
        if (!is_same) return see_change(path, entry, facts, delay, now);
        entry.since = now;
        return enter_phase(path, entry, Phase::done);
    case Phase::settling:
        if (!is_same || entry.facts.blocks != facts.blocks) return see_change(path, entry, facts, delay, now);
        if (now >= entry.look_at) return enter_phase(path, entry, Phase::due);
        if (look == LookKind::closed && !entry.attempts.is_waiting() && now + delay < entry.look_at)
            settle_file(path, entry, delay, now);
        return;
    case Phase::due:
    case Phase::running:
    case Phase::done:
        if (!is_same) return see_change(path, entry, facts, delay, now);
        entry.facts = facts;
        return;
    }
}

void Schedule::see_new_file(const std::string& path, const FileFacts& facts, LookKind look, Time now) {
    const LeavingFiles::Return before = leaving_.take_back(path, facts);
    std::optional<std::string> from;
    if (!before.record_holds) from = leaving_.take_renamed(facts);
    if (from) actions_.push_back({.kind = Action::Kind::move, .path = path, .from = *from, .facts = facts});
    Entry& entry = entries_[path];
    entry.facts = facts;
    entry.since = now;
    entry.is_remote = look == LookKind::remote;
    entry.recorded = before.is_recorded || from ? Recorded::yes : Recorded::no;
    if (before.record_holds || from)
        enter_phase(path, entry, Phase::done);
    else
        settle_file(path, entry, pace_.quiet_after(look), now);
}

void Schedule::see_change(const std::string& path, Entry& entry, const FileFacts& facts, nanoseconds delay,
                          Time now) {
    if (entry.phase == Phase::running) actions_.push_back({.kind = Action::Kind::stop, .path = path});
    const bool keeps_changing = entry.phase == Phase::settling;
    enter_phase(path, entry, Phase::settling);  // before the facts, by which it is ordered, change
    entry.facts = facts;
    entry.since = now;
    entry.attempts = {};
    end_part(entry);
    if (keeps_changing && entry.recorded != Recorded::waiting) {
        entry.recorded = Recorded::waiting;
        actions_.push_back({.kind = Action::Kind::hold, .path = path, .facts = facts});
    }
    settle_file(path, entry, delay, now);
}

void Schedule::settle_file(const std::string& path, Entry& entry, nanoseconds delay, Time now) {
    enter_phase(path, entry, Phase::settling);
    entry.look_at = now + delay;
    looks_.emplace(entry.look_at, path);
}

/// The only place where a phase changes: looks_ and due_ follow.
void Schedule::enter_phase(const std::string& path, Entry& entry, Phase phase) {
    looks_.erase({entry.look_at, path});
    due_.erase({turn_of(path, entry.facts), path});
    entry.phase = phase;
    if (phase == Phase::due) due_.emplace(turn_of(path, entry.facts), path);
}

void Schedule::lose_file(const std::string& path, Time now) {
    const auto found = entries_.find(path);
    if (found == entries_.end()) return;
    Entry& entry = found->second;
    if (entry.phase == Phase::running) actions_.push_back({.kind = Action::Kind::stop, .path = path});
    if (entry.recorded != Recorded::no)
        leaving_.add(path, entry.facts, entry.phase == Phase::done, now + pace_.rename_grace);
    enter_phase(path, entry, Phase::unseen);
    entries_.erase(found);
}

void Schedule::end_part(Entry& entry) {
    if (entry.recorded == Recorded::part) entry.recorded = Recorded::yes;
}

bool Schedule::mark_grown(const std::string& path) {
    const auto found = entries_.find(path);
    if (found == entries_.end() || found->second.phase != Phase::running) return false;
    found->second.recorded = Recorded::part;
    return true;
}

Verdict Schedule::finish_analysis(const std::string& path, Answer answer, Time now) {
    slots_.end(path);
    std::erase_if(actions_,
                  [&](const Action& action) {  // it was seen to change just now: nothing is left to stop
                      return action.kind == Action::Kind::stop && action.path == path;
                  });
    const auto found = entries_.find(path);
    if (found == entries_.end() || found->second.phase != Phase::running) return Verdict::discard;
    Entry& entry = found->second;
    end_part(entry);
    const bool have_others_died = answer == Answer::died && slots_.note_death(path, now, pace_.death_memory);
    const Attempts::Next next = entry.attempts.note_answer(
        answer, {.is_remote = entry.is_remote, .have_others_died = have_others_died}, pace_);
    if (next.verdict != Verdict::retry) entry.recorded = next.retry_after ? Recorded::waiting : Recorded::yes;
    if (next.retry_after) {
        settle_file(path, entry, *next.retry_after, now);
    } else {
        enter_phase(path, entry, Phase::done);
        entry.since = now;
    }
    return next.verdict;
}

bool Schedule::analyse_again(const std::string& path) {
    const auto found = entries_.find(path);
    if (found == entries_.end() || found->second.phase != Phase::done) return false;
    enter_phase(path, found->second, Phase::due);
    return true;
}

std::vector<std::string> Schedule::files_to_look_at(Time now) const {
    std::vector<std::string> paths;
    for (auto it = looks_.begin(); it != looks_.end() && it->first <= now; ++it)
        paths.push_back(it->second);
    return paths;
}

std::vector<Action> Schedule::next_actions(Time now) {
    for (const std::string& path : leaving_.take_expired(now))
        actions_.push_back({.kind = Action::Kind::remove, .path = path});
    start_due_files();
    return std::exchange(actions_, {});
}

/// Newest first: its operator waits for the file that was just dropped. A photo does not wait for a film that
/// takes minutes, and a notice for nothing.
void Schedule::start_due_files() {
    for (auto it = due_.rbegin(); it != due_.rend() && slots_.size() <= pace_.children + 1;) {
        const std::string path = it->second;
        ++it;
        if (slots_.contains(path)) continue;  // the stopped one is not gone yet
        Entry& entry = entries_.at(path);
        const bool is_small = entry.facts.bytes <= pace_.small_bytes;
        const std::size_t more = notice_named(path) ? 2 : is_small ? 1 : 0;
        if (slots_.size() >= pace_.children + more) continue;
        it = std::make_reverse_iterator(due_.erase(it.base()));
        entry.phase = Phase::running;
        slots_.begin(path);
        actions_.push_back({.kind = Action::Kind::start,
                            .path = path,
                            .facts = entry.facts,
                            .is_last_try = entry.attempts.is_last(pace_)});
    }
}

std::optional<Schedule::Time> Schedule::next_wake() const {
    std::optional<Time> earliest = leaving_.next_expiry();
    if (!looks_.empty()) earliest = std::min(earliest.value_or(looks_.begin()->first), looks_.begin()->first);
    return earliest;
}

std::vector<std::string> Schedule::paths_below(const std::string& folder) const {
    std::vector<std::string> paths;
    const std::string prefix = folder.empty() ? "" : folder + "/";
    for (auto it = entries_.lower_bound(prefix); it != entries_.end() && it->first.starts_with(prefix); ++it)
        paths.push_back(it->first);
    return paths;
}

Schedule::Progress Schedule::progress_of(const Entry& entry) {
    if (entry.phase == Phase::done) return Progress::done;
    if (entry.attempts.is_waiting()) return Progress::waiting;
    if (entry.phase == Phase::running)
        return entry.recorded == Recorded::part ? Progress::growing : Progress::due;
    return entry.phase == Phase::due ? Progress::due : Progress::settling;
}

void Schedule::visit_files(const Visit& call) const {
    for (const auto& [path, entry] : entries_)
        if (entry.phase != Phase::unseen && entry.phase != Phase::stale)
            call(path, progress_of(entry), entry.since);
}

bool Schedule::is_idle() const {
    return slots_.is_empty() && due_.empty() && leaving_.is_empty() && actions_.empty() &&
           std::all_of(looks_.begin(), looks_.end(),
                       [&](const auto& look) { return entries_.at(look.second).attempts.is_waiting(); });
}

}  // namespace vitrine::analyzer
