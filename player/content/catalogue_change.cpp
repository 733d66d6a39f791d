#include "player/content/catalogue_change.hpp"

namespace vitrine::player {

namespace {

/// The record of a file where that is ready.
RecordList::Record find_ready(const RecordList& records, const std::string& path) {
    RecordList::Record found = records.find(path);
    return found && is_ready(*found) ? found : nullptr;
}

bool is_same(const RecordList::Record& a, const RecordList::Record& b) {
    return a == b || (a && b && *a == *b);
}

}  // namespace

bool is_ready(const MediaRecord& record) {
    return record.state == MediaState::ready && !record.shots.empty();
}

CatalogueChange change_between(const RecordList& before, const RecordList& after) {
    CatalogueChange change;
    for (const RecordList::Record& record : after) {
        if (!is_ready(*record)) {
            change.has_others = change.has_others || !is_same(before.find(record->path), record);
            continue;
        }
        const RecordList::Record old = find_ready(before, record->path);
        if (!old)
            change.added.push_back(record->path);
        else if (!is_same(old, record))
            (is_grown_from(*record, *old) ? change.grown : change.replaced).push_back(record->path);
    }
    for (const RecordList::Record& record : before) {
        if (is_ready(*record) && !find_ready(after, record->path)) change.gone.push_back(record->path);
        change.has_others = change.has_others || (!is_ready(*record) && !after.find(record->path));
    }
    return change;
}

}  // namespace vitrine::player
