#include "player/content/programme_follower.hpp"

#include "base/system/atomic_file.hpp"
#include "base/system/log.hpp"

#include <stdexcept>

namespace vitrine::player {

namespace fs = std::filesystem;

ProgrammeFollower::ProgrammeFollower(const fs::path& state)
    : file_(state / "hints.json"), calendar_(state / "catalogue") {}

bool ProgrammeFollower::look(std::optional<std::chrono::local_seconds> rehearsed) {
    read_folders();
    const auto now = rehearsed ? rehearsed : calendar_.now();
    const bool is_other = programme_.advance(now);
    if (programme_.is_scheduled()) tell(now.has_value());
    return is_other;
}

/// The analyzer replaces it as a whole. What cannot be read leaves in force what was.
void ProgrammeFollower::read_folders() {
    std::error_code missing;
    const auto time = fs::last_write_time(file_, missing);
    if (missing) return;
    const auto size = fs::file_size(file_, missing);
    if (missing || read_ == std::pair(time, size)) return;
    read_ = {time, size};
    try {
        programme_.set_folders(folder_hints_from_json(read_file(file_)));
    } catch (const std::runtime_error& error) {  // one file that somebody has damaged
        log::warning("'{}' unreadable, ignoring: {}", file_.string(), error.what());
    }
}

void ProgrammeFollower::tell(bool has_time) {
    if (told_time_ != has_time) {
        if (!has_time)
            log::warning("the clock cannot be right yet: what has a period or hours is not shown");
        else if (told_time_)
            log::info("the clock can be right: what has a period or hours is shown at its time");
        told_time_ = has_time;
    }
    if (told_open_ == programme_.count_open()) return;
    told_open_ = programme_.count_open();
    log::info("programme: {} of {} files may be shown now", told_open_, programme_.count());
}

}  // namespace vitrine::player
