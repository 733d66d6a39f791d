#include "player/content/hours_follower.hpp"

#include "base/hints/hint_words.hpp"
#include "base/system/atomic_file.hpp"
#include "base/system/log.hpp"

#include <stdexcept>
#include <utility>

namespace vitrine::player {

namespace fs = std::filesystem;

HoursFollower::HoursFollower(const fs::path& state, const ShowDays& days)
    : file_(state / "hints.json"),
      hours_(days.holidays),
      calendar_(state / "catalogue"),
      on_this_day_(days.on_this_day) {}

bool HoursFollower::look(std::optional<std::chrono::local_seconds> rehearsed) {
    read_folders();
    const auto now = rehearsed ? rehearsed : calendar_.now();
    has_time_ = now.has_value();
    today_.reset();
    if (now && on_this_day_) today_ = std::chrono::floor<std::chrono::days>(*now);
    const bool is_other = hours_.advance(now);
    if (hours_.has_hours()) log_clock();
    return is_other;
}

std::string HoursFollower::hours_of(const std::string& path) const {
    const ShowHints::Entry file = hours_.hints().find(path);
    if (!file) return {};
    Hints times;
    times.period = file->hints.period;
    times.hours = file->hints.hours;
    times.weekdays = file->hints.weekdays;
    return in_words(times);
}

/// Reads the folders' hints; the analyzer replaces the file as a whole. If the file cannot be read, the hints
/// stay.
void HoursFollower::read_folders() {
    std::error_code missing;
    const auto time = fs::last_write_time(file_, missing);
    if (missing) return;
    const auto size = fs::file_size(file_, missing);
    if (missing || read_ == Version(time, size)) return;
    read_ = Version(time, size);
    try {
        hours_.set_folders(folder_hints_from_json(read_file(file_)));
    } catch (const std::runtime_error& error) {  // the file is damaged
        log::warning("'{}' unreadable, ignoring: {}", file_.string(), error.what());
    }
}

void HoursFollower::log_clock() {
    if (logged_time_ == has_time_) return;
    if (!has_time_)
        log::warning("the clock is not plausible yet: files with days or hours are not shown");
    else if (logged_time_)
        log::info("the clock is plausible: files with days or hours are shown at their time");
    logged_time_ = has_time_;
}

}  // namespace vitrine::player
