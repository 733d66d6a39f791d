#include "player/scene/programme.hpp"

#include <algorithm>
#include <utility>

namespace vitrine::player {

void Programme::set_records(std::vector<MediaRecord> records) {
    entries_.clear();
    for (MediaRecord& record : records)
        entries_.push_back({.record = std::move(record)});
    read_hints();
}

void Programme::set_folders(FolderHints folders) {
    folders_ = std::move(folders);
    read_hints();
}

void Programme::read_hints() {
    hints_.clear();
    is_scheduled_ = false;
    for (Entry& entry : entries_) {
        entry.hints = hints_of(entry.record.path, folders_);
        if (entry.hints != Hints{}) hints_.emplace(entry.record.path, entry.hints);
        is_scheduled_ = is_scheduled_ || entry.hints.is_scheduled();
    }
    is_new_ = true;
}

bool Programme::advance(std::optional<std::chrono::local_seconds> now) {
    bool is_other = std::exchange(is_new_, false);
    if (!is_other && !is_scheduled_) return false;
    for (Entry& entry : entries_) {
        const bool was_open = std::exchange(entry.is_open, vitrine::is_open(entry.hints, now));
        is_other = is_other || was_open != entry.is_open;
    }
    return is_other;
}

std::vector<MediaRecord> Programme::open() const {
    std::vector<MediaRecord> records;
    for (const Entry& entry : entries_)
        if (entry.is_open) records.push_back(entry.record);
    return records;
}

std::size_t Programme::count_open() const {
    return static_cast<std::size_t>(std::ranges::count_if(entries_, &Entry::is_open));
}

}  // namespace vitrine::player
