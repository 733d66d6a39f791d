#include "player/content/catalogue_follower.hpp"

#include "base/system/log.hpp"

#include <sys/epoll.h>

#include <algorithm>
#include <utility>

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;

constexpr auto settle_time = 150ms;  // many records written together are one change
constexpr auto retry_time = 1s;

const MediaRecord* find(const std::vector<MediaRecord>& records, const std::string& path) {
    const auto found = std::lower_bound(
        records.begin(), records.end(), path,
        [](const MediaRecord& record, const std::string& wanted) { return record.path < wanted; });
    return found != records.end() && found->path == path ? &*found : nullptr;
}

}  // namespace

CatalogueChange change_between(const std::vector<MediaRecord>& before,
                               const std::vector<MediaRecord>& after) {
    CatalogueChange change;
    for (const MediaRecord& record : after) {
        const MediaRecord* old = find(before, record.path);
        if (old == nullptr)
            change.added.push_back(record.path);
        else if (*old != record && is_grown_from(record, *old))
            change.grown.push_back(record.path);
        else if (*old != record)
            change.replaced.push_back(record.path);
    }
    for (const MediaRecord& record : before)
        if (find(after, record.path) == nullptr) change.gone.push_back(record.path);
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
    for (const MediaRecord& record : records)
        ++counts_[record.state];
    std::erase_if(records, [](const MediaRecord& record) {
        return record.state != MediaState::ready || record.shots.empty();
    });
    const CatalogueChange change = change_between(records_, records);
    records_ = std::move(records);
    if (!change.is_empty()) call_(change);
}

}  // namespace vitrine::player
