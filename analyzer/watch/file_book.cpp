#include "analyzer/watch/daemon.hpp"

#include "base/state/blame.hpp"
#include "base/system/log.hpp"

#include <stdexcept>
#include <system_error>
#include <utility>

// What the daemon does to the records.

namespace vitrine::analyzer {

namespace fs = std::filesystem;

void Daemon::load_catalogue() {
    const auto records = catalogue_.load([](const std::string& file, const std::string& reason) {
        log::warning("record '{}' unreadable, its file is analysed again: {}", file, reason);
        std::error_code ignored;  // it is overwritten at the latest
        fs::remove(file, ignored);
    });
    for (const MediaRecord& record : records) {
        const bool is_waiting = record.state == MediaState::waiting;
        schedule_.add_recorded(record.path, {.bytes = record.bytes, .mtime_ns = record.mtime_ns},
                               !is_waiting && record.is_complete && !store_.lacks(record), is_waiting);
        store_.hold(record);
        states_.note_record(record);
        weaver_.hold(record);
        if (!record.is_complete) growing_.known(record);
    }
}

/// A record that was damaged meanwhile is missed until the next start, which finds its file unknown.
void Daemon::move(const Action& action) {
    std::optional<MediaRecord> record = stored(action.from);
    if (!record) return log::warning("renamed without a record: '{}'", action.path);
    record->path = action.path;
    weaver_.move(action.from, action.path);
    store(*record);
    remove_record(action.from);
    store_.release(action.from);
    states_.forget_file(action.from);
    weaver_.release(action.from);
    heard_.erase(action.from);
    hints_.arm(std::chrono::seconds(0));  // the new name may say something else
    std::error_code none;                 // only a picture for the status folder
    fs::rename(thumbnail(action.from), thumbnail(action.path), none);
    log::info("renamed: '{}' to '{}'", action.from, action.path);
}

std::optional<MediaRecord> Daemon::stored(const std::string& path) const {
    try {
        return catalogue_.find(path);
    } catch (const std::runtime_error& error) {  // loading one record
        log::warning("record of '{}' unreadable, ignoring: {}", path, error.what());
        return std::nullopt;
    }
}

/// What brings the player down is not shown, until it changes.
void Daemon::follow_blame() {
    const Blame blame = read_blame(options_.catalogue.parent_path());
    for (const std::string& path : suspects(blame, schedule_.paths_below(""))) {
        const std::optional<MediaRecord> record = stored(path);
        if (!record || record->state != MediaState::ready || !is_quarantined(blame, *record)) continue;
        const FileFacts facts{.bytes = record->bytes, .mtime_ns = record->mtime_ns};
        store(record_of(path, facts, MediaState::quarantined, brought_the_player_down));
        log::warning("quarantined: '{}': {}", path, brought_the_player_down);
    }
}

/// What lost its place in the store is played from the media folder.
void Daemon::make_room() {
    const std::set<std::string> paths = store_.make_room();
    for (const std::string& path : paths)
        if (const std::optional<MediaRecord> record = stored(path)) store(*record);
    if (!paths.empty())
        log::info("the store is full: {} files lose their place or a part of it", paths.size());
}

/// A full disk is no reason to stop: the record waits here.
void Daemon::store(MediaRecord record) {
    store_.mark_dropped(record);
    store_.hold(record);
    states_.note_record(record);
    weaver_.hold(record);
    unremoved_.erase(record.path);
    try {
        catalogue_.store(record);
        unsaved_.erase(record.path);
    } catch (const std::system_error& error) {
        if (!std::exchange(is_lack_told_, true))
            log::error("records cannot be stored, trying again: {}", error.what());
        unsaved_[record.path] = record;
    }
}

/// Nor is a disk that takes nothing at all.
void Daemon::remove_record(const std::string& path) {
    unsaved_.erase(path);
    try {
        catalogue_.remove(path);
    } catch (const fs::filesystem_error& error) {
        if (!std::exchange(is_lack_told_, true))
            log::error("records cannot be removed, trying again: {}", error.what());
        unremoved_.insert(path);
    }
}

void Daemon::store_again() {
    for (const auto& [path, record] : std::exchange(unsaved_, {}))
        store(record);
    for (const std::string& path : std::exchange(unremoved_, {}))
        remove_record(path);
    if (unsaved_.empty() && unremoved_.empty() && std::exchange(is_lack_told_, false))
        log::info("all records are stored again");
}

}  // namespace vitrine::analyzer
