#include "player/content/catalogue_follower.hpp"

#include "base/system/log.hpp"

#include <sys/epoll.h>

#include <algorithm>
#include <utility>

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;

constexpr auto settle_time = 150ms;  // records that are written together are one change
constexpr auto retry_time = 1s;

/// The record of a file. None: the file is not ready.
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

CatalogueFollower::CatalogueFollower(EventLoop& loop, Catalogue catalogue, Call call)
    : catalogue_(std::move(catalogue)),
      call_(std::move(call)),
      events_(loop.watch(directory_watch_.fd(), EPOLLIN, [this](std::uint32_t) { read_events(); })),
      settled_(loop.timer([this] { reload(); })),
      retry_(loop.timer([this] { watch(); })) {
    watch();
}

void CatalogueFollower::watch() {
    if (!directory_watch_.add(catalogue_.directory())) retry_.arm(retry_time);
    reload();
}

void CatalogueFollower::read_events() {
    for (const DirectoryEvent& event : directory_watch_.read())
        if (event.kind == DirectoryEvent::Kind::self_gone) retry_.arm(retry_time);
    settled_.arm(settle_time);
}

void CatalogueFollower::reload() {
    std::map<std::string, std::string> complaints;
    std::vector<MediaRecord> records =
        catalogue_.load([&](const std::string& file, const std::string& reason) {
            if (!complaints_.contains(file))
                log::warning("record '{}' unreadable, ignoring: {}", file, reason);
            complaints.emplace(file, reason);
        });
    complaints_ = std::move(complaints);
    counts_.clear();
    RecordList list;
    for (MediaRecord& record : records) {
        ++counts_[record.state];
        RecordList::Record known = records_.find(record.path);
        const bool is_known = known && *known == record;
        list.add(is_known ? std::move(known) : std::make_shared<const MediaRecord>(std::move(record)));
    }
    const CatalogueChange change = change_between(records_, list);
    records_ = std::move(list);
    if (!change.is_empty()) call_(change, records_);
}

}  // namespace vitrine::player
