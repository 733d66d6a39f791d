#include "player/content/crash_note.hpp"

#include "base/state/acquittal.hpp"
#include "base/system/atomic_file.hpp"
#include "base/system/log.hpp"
#include "player/content/crash_signal.hpp"

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

namespace vitrine::player {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

namespace {

constexpr auto usual_opening = 10s;     // a crash within this time is put down to the opened file
constexpr auto max_opening = 60s;       // the same for a file that was open in several crashes
constexpr auto forgiving_time = 10min;  // time without a crash until all is forgiven
constexpr auto doubtful_time = 1h;      // if several files crash within this time, none of them is condemned

std::string content_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::string this_boot() {
    std::string id;
    std::ifstream("/proc/sys/kernel/random/boot_id") >> id;
    return id;
}

std::chrono::seconds wall_clock() {
    return std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now().time_since_epoch());
}

}  // namespace

bool CrashNote::is_quarantined(const MediaRecord& record) const {
    return find_quarantine(blame_, record, wall_clock()).has_value();
}

CrashNote::CrashNote(fs::path state)
    : state_(std::move(state)),
      blame_(read_blame(state_)),
      note_{.boot = this_boot(), .process = ::getpid(), .opening = {}, .playing = {}} {
    count_crash();
    quarantined_ = count_quarantined(blame_, wall_clock());
    if (is_active_) note_own_crash(state_ / crashed_file);
    for (const auto& [name, suspicion] : blame_)
        if (suspicion.points >= suspect_points && suspicion.points < quarantine_points)
            suspects_.insert(name);
    if (suspects_.size() > 1)
        log::info("{} files are shown again one after another: one of them may crash the player",
                  suspects_.size());
    else
        suspects_.clear();  // a further crash counts for this file anyway
}

void CrashNote::count_crash() {
    const PlayingNote left = playing_note_from(content_of(state_ / playing_file));
    if (left.boot != note_.boot || left.process == note_.process) return;
    if (left.process > 0 && ::kill(left.process, 0) == 0) {
        is_active_ = false;
        return log::warning("another player uses this state directory: crashes of this one are not counted");
    }
    if (!has_own_crash(state_ / crashed_file)) {
        log::warning("the player was killed with {} files open; no file is blamed",
                     left.opening.size() + left.playing.size());
        return end_run();
    }
    blame_ = blame_after(blame_, left, wall_clock());
    log::warning("the player crashed while {} files were being opened and {} were playing",
                 left.opening.size(), left.playing.size());
    try {
        replace_file(state_ / blamed_file, to_text(blame_));
        end_run();
    } catch (const std::system_error& error) {
        is_active_ = false;
        log::warning("the crash is not counted: {}", error.what());
    }
}

bool CrashNote::is_on_hold(const MediaRecord& record) const {
    if (suspects_.empty()) return false;
    const ContentName name = content_name(record);
    return suspects_.contains(name) && name != on_trial_;
}

bool CrashNote::set_files(const RecordList& files) {
    files.for_each_change(files_, [&](const RecordList::Record& /*before*/, const RecordList::Record& now) {
        if (now) log_quarantine(*now);
    });
    files_ = files;
    return !suspects_.empty() && choose_suspect();
}

/// Logs once that a file is quarantined, if it is.
void CrashNote::log_quarantine(const MediaRecord& record) {
    if (is_quarantined(record) && logged_.insert(record.path).second)
        log::warning("quarantined: '{}': {}", record.path, brought_the_player_down);
}

/// Puts the first suspect on trial if none is. True: another file is on trial now.
bool CrashNote::choose_suspect() {
    const RecordList::Record tried = files_.find(trial_path_);
    if (tried && on_trial_ == content_name(*tried)) return false;
    const auto next = std::ranges::find_if(
        files_, [&](const RecordList::Record& record) { return suspects_.contains(content_name(*record)); });
    const bool is_found = next != files_.end();
    const auto before =
        std::exchange(on_trial_, is_found ? std::optional(content_name(**next)) : std::nullopt);
    trial_path_ = is_found ? (*next)->path : "";
    trial_begin_.reset();
    return on_trial_ != before;
}

void CrashNote::note_opening(const MediaRecord& record, Time now) {
    if (start_ == Time{}) start_ = now;
    opened_[content_name(record)] = now;
    if (content_name(record) == on_trial_ && !trial_begin_) trial_begin_ = now;
    if (note_.opening.insert(content_name(record)).second) write();
}

std::chrono::seconds CrashNote::opening_time(const ContentName& name) const {
    const auto found = blame_.find(name);
    return found != blame_.end() && found->second.points == quarantine_points - 1 ? max_opening
                                                                                  : usual_opening;
}

void CrashNote::note_reader_crash(const MediaRecord& record, Time now) {
    const ContentName name = content_name(record);
    std::erase_if(reader_crashes_, [&](const auto& entry) { return now - entry.second > doubtful_time; });
    reader_crashes_[name] = now;
    start_ = now;
    log::warning("its reader crashed: '{}'", record.path);
    blame_ = blame_after_reader(std::move(blame_), name, reader_crashes_.size() == 1, wall_clock());
    if (is_active_) write_blame();
}

/// Without a disk that takes it, the quarantine lasts as long as this run.
void CrashNote::write_blame() {
    try {
        replace_file(state_ / blamed_file, to_text(blame_));
    } catch (const std::system_error& error) {
        log::debug("the files that crashed cannot be noted: {}", error.what());
    }
}

bool CrashNote::note_open(const std::set<ContentName>& open, Time now) {
    if (start_ == Time{}) start_ = now;
    std::erase_if(opened_, [&](const auto& entry) { return !open.contains(entry.first); });
    PlayingNote note{.boot = note_.boot, .process = note_.process, .opening = {}, .playing = {}};
    for (const auto& [name, since] : opened_)
        (now - since < opening_time(name) ? note.opening : note.playing).insert(name);
    const bool is_cleared = end_trial(now), has_other_quarantines = follow_quarantines();
    if (now - start_ > forgiving_time) forgive();
    if (note != note_) {
        note_ = std::move(note);
        write();
    }
    return is_cleared || has_other_quarantines;
}

/// True: a quarantine has begun or ended since the last call.
bool CrashNote::follow_quarantines() {
    const std::size_t before = std::exchange(quarantined_, count_quarantined(blame_, wall_clock()));
    if (quarantined_ == before) return false;
    for (const RecordList::Record& record : files_)
        log_quarantine(*record);
    return true;
}

/// Ends a trial that has lasted long enough, or when all is forgiven. True: there was one.
bool CrashNote::end_trial(Time now) {
    if (suspects_.empty()) return false;
    if (now - start_ > forgiving_time) {
        suspects_.clear();
    } else {
        if (!on_trial_ || !trial_begin_ || now - *trial_begin_ < opening_time(*on_trial_)) return false;
        suspects_.erase(*on_trial_);
    }
    on_trial_.reset();
    trial_begin_.reset();
    return true;
}

void CrashNote::forgive() {
    const auto forgiven =
        std::erase_if(blame_, [](const auto& entry) { return entry.second.quarantines == 0; });
    if (forgiven > 0 && is_active_) write_blame();
}

/// A rename alone makes the note whole: it is read only after this process has ended.
void CrashNote::write() {
    if (!is_active_) return;
    const fs::path file = state_ / playing_file;
    std::ofstream stream(unfinished(file), std::ios::binary | std::ios::trunc);
    stream << to_text(note_);
    stream.close();
    std::error_code failure;
    if (stream) fs::rename(unfinished(file), file, failure);
    if (stream && !failure) return;
    is_active_ = false;
    fs::remove(unfinished(file), failure);
    fs::remove(file, failure);  // its text is out of date
    log::warning("the open files cannot be noted in '{}': a file that crashes the player will not be found",
                 state_.string());
}

void CrashNote::acquit(const std::string& path) {
    write_acquittal(state_, path, wall_clock());
    const auto is_meant = [id = record_id(path), &path](const ContentName& name) {
        return path.empty() || name.id == id;
    };
    std::erase_if(blame_, [&](const auto& entry) { return is_meant(entry.first); });
    std::erase_if(suspects_, is_meant);
    if (on_trial_ && is_meant(*on_trial_)) {
        on_trial_.reset();
        trial_begin_.reset();
    }
    logged_.clear();
    replace_file(state_ / blamed_file, to_text(blame_));
}

void CrashNote::end_run() {
    std::error_code ignored;
    if (!is_active_) return;
    fs::remove(state_ / playing_file, ignored);
    fs::remove(state_ / crashed_file, ignored);
}

}  // namespace vitrine::player
