#include "player/scene/show_files.hpp"

#include <algorithm>

namespace vitrine::player {

RecordList::RecordList(std::span<const MediaRecord> records) {
    for (const MediaRecord& record : records)
        add(std::make_shared<const MediaRecord>(record));
}

RecordList::Record RecordList::find(const std::string& path) const {
    const auto found = std::ranges::lower_bound(
        records_, path, {}, [](const Record& record) -> const std::string& { return record->path; });
    return found != records_.end() && (*found)->path == path ? *found : nullptr;
}

RecordList RecordList::in_folder(const std::string& folder) const {
    if (folder.empty()) return *this;
    RecordList within;
    for (const Record& record : records_)
        if (record->path.starts_with(folder + "/")) within.add(record);
    return within;
}

}  // namespace vitrine::player
