#include "player/content/judged_files.hpp"

#include <memory>

namespace vitrine::player {

bool has_passed_filters(Visibility visibility) {
    return may_be_shown(visibility) || visibility == Visibility::other_folder ||
           visibility == Visibility::screens_off || visibility == Visibility::closed_folder ||
           visibility == Visibility::avoided;
}

bool JudgedFiles::judge(const std::set<std::string>& paths, const RecordList& records) {
    Changes changes;
    for (const std::string& path : paths) {
        if (const RecordList::Record record = records.find(path))
            judge_file(record, changes);
        else
            forget_file(path, changes);
    }
    return apply(changes);
}

bool JudgedFiles::judge_all(const RecordList& records) {
    Changes changes;
    for (const RecordList::Record& record : records)
        judge_file(record, changes);
    for (const List::Entry& known : all_)
        if (!records.contains(known->path)) forget_file(known->path, changes);
    return apply(changes);
}

void JudgedFiles::judge_file(const RecordList::Record& record, Changes& changes) {
    ++judgements_;
    FileVisibility now = judge_(*record);
    const RecordList::Record shown = has_passed_filters(now.visibility) ? record : nullptr;
    if (visible_.find(record->path) != shown) changes.visible[record->path] = shown;
    const List::Entry before = all_.find(record->path);
    if (before && *before == now) return;
    if (before) --counts_[before->visibility];
    ++counts_[now.visibility];
    changes.judged[record->path] = std::make_shared<const FileVisibility>(std::move(now));
}

void JudgedFiles::forget_file(const std::string& path, Changes& changes) {
    const List::Entry before = all_.find(path);
    if (!before) return;
    --counts_[before->visibility];
    changes.judged[path] = nullptr;
    if (visible_.contains(path)) changes.visible[path] = nullptr;
}

bool JudgedFiles::apply(const Changes& changes) {
    all_.apply(changes.judged);
    visible_.apply(changes.visible);
    return !changes.visible.empty();
}

}  // namespace vitrine::player
