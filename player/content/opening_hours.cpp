#include "player/content/opening_hours.hpp"

#include <utility>

namespace vitrine::player {

void OpeningHours::set_files(const RecordList& files) {
    files_ = files;
    read_hints();
}

void OpeningHours::set_folders(FolderHints folders) {
    folders_ = std::move(folders);
    read_hints();
}

void OpeningHours::read_hints() {
    hints_.clear();
    has_hours_ = false;
    for (const RecordList::Record& file : files_) {
        const Hints hints = hints_of(file->path, folders_);
        if (hints != Hints{}) hints_.emplace(file->path, hints);
        has_hours_ = has_hours_ || hints.is_scheduled();
    }
    is_new_ = true;
}

bool OpeningHours::advance(std::optional<std::chrono::local_seconds> now) {
    const bool is_new = std::exchange(is_new_, false);
    if (!is_new && !has_hours_) return false;
    std::set<std::string> closed;
    for (const auto& [path, hints] : hints_)
        if (!vitrine::is_open(hints, now)) closed.insert(path);
    const bool is_other = is_new || closed != closed_;
    closed_ = std::move(closed);
    return is_other;
}

}  // namespace vitrine::player
