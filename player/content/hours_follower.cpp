#include "player/content/hours_follower.hpp"

#include "base/system/atomic_file.hpp"
#include "base/system/log.hpp"

#include <stdexcept>

namespace vitrine::player {

namespace fs = std::filesystem;

HoursFollower::HoursFollower(const fs::path& state)
    : file_(state / "hints.json"), calendar_(state / "catalogue") {}

bool HoursFollower::look(std::optional<std::chrono::local_seconds> rehearsed) {
    read_folders();
    const auto now = rehearsed ? rehearsed : calendar_.now();
    const bool is_other = hours_.advance(now);
    if (hours_.has_hours()) tell(now.has_value());
    return is_other;
}

RecordList HoursFollower::open() const {
    RecordList open;
    for (const RecordList::Record& file : files_)
        if (hours_.is_open(file->path)) open.add(file);
    return open;
}

/// The analyzer replaces it as a whole. What cannot be read leaves in force what was.
void HoursFollower::read_folders() {
    std::error_code missing;
    const auto time = fs::last_write_time(file_, missing);
    if (missing) return;
    const auto size = fs::file_size(file_, missing);
    if (missing || read_ == std::pair(time, size)) return;
    read_ = {time, size};
    try {
        hours_.set_folders(folder_hints_from_json(read_file(file_)));
    } catch (const std::runtime_error& error) {  // one file that somebody has damaged
        log::warning("'{}' unreadable, ignoring: {}", file_.string(), error.what());
    }
}

void HoursFollower::tell(bool has_time) {
    if (told_time_ != has_time) {
        if (!has_time)
            log::warning("the clock cannot be right yet: what has a period or hours is not shown");
        else if (told_time_)
            log::info("the clock can be right: what has a period or hours is shown at its time");
        told_time_ = has_time;
    }
    if (told_closed_ == hours_.count_closed()) return;
    told_closed_ = hours_.count_closed();
    log::info("hours: {} of {} files may be shown now", files_.size() - told_closed_, files_.size());
}

}  // namespace vitrine::player
