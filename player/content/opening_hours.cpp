#include "player/content/opening_hours.hpp"

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

namespace vitrine::player {

void OpeningHours::set_files(const RecordList& files) {
    ShowHints::Changes changes;
    files.for_each_change(files_, [&](const RecordList::Record& before, const RecordList::Record& now) {
        if (before && now) return;  // hints depend on the path alone
        const std::string& path = (now ? now : before)->path;
        set_hints(path, now ? hints_of(path, folders_) : Hints{}, changes);
    });
    files_ = files;
    hints_.apply(changes);
    is_new_ = true;
}

void OpeningHours::set_folders(FolderHints folders) {
    folders_ = std::move(folders);
    ShowHints::Changes changes;
    for (const RecordList::Record& file : files_)
        set_hints(file->path, hints_of(file->path, folders_), changes);
    hints_.apply(changes);
    is_new_ = true;
}

/// @param changes  where the change of hints_ is added
void OpeningHours::set_hints(const std::string& path, const Hints& hints, ShowHints::Changes& changes) {
    const ShowHints::Entry before = hints_.find(path);
    if (hints == (before ? before->hints : Hints{})) return;
    const HintedFile file{.path = path, .hints = hints};
    changes[path] = hints == Hints{} ? nullptr : std::make_shared<const HintedFile>(file);
    changed_.insert(path);
    if (hints.is_scheduled())
        scheduled_.insert_or_assign(path, hints);
    else
        scheduled_.erase(path);
}

bool OpeningHours::advance(std::optional<std::chrono::local_seconds> now) {
    const bool is_new = std::exchange(is_new_, false);
    const bool had_time = std::exchange(has_time_, now.has_value());
    const bool is_time_other = had_time != has_time_ && has_hours();
    if (is_time_other)
        for (const auto& [path, hints] : scheduled_)
            changed_.insert(path);
    std::set<std::string> closed;
    for (const auto& [path, hints] : scheduled_)
        if (!vitrine::is_open(hints, now, holidays_)) closed.insert(path);
    const bool is_other = is_new || is_time_other || closed != closed_;
    std::ranges::set_symmetric_difference(closed, closed_, std::inserter(changed_, changed_.end()));
    closed_ = std::move(closed);
    return is_other;
}

std::set<std::string> OpeningHours::take_changed() {
    return std::exchange(changed_, {});
}

}  // namespace vitrine::player
