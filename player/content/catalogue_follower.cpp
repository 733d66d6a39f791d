#include "player/content/catalogue_follower.hpp"

#include "base/system/event_file.hpp"
#include "base/system/log.hpp"

#include <sys/epoll.h>

#include <utility>

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;

constexpr auto settle_time = 100ms;      // records that are written together are one change
constexpr auto max_settle_time = 250ms;  // also where the writing never ends
constexpr auto retry_time = 1s;

}  // namespace

CatalogueFollower::CatalogueFollower(EventLoop& loop, Catalogue catalogue, Call call)
    : directory_(catalogue.directory()),
      call_(std::move(call)),
      news_(event_file()),
      events_(loop.watch(directory_watch_.fd(), EPOLLIN, [this](std::uint32_t) { read_events(); })),
      settled_(loop.timer([this] { request_changed(); })),
      retry_(loop.timer([this] { watch(); })),
      told_(loop.watch(news_.get(), EPOLLIN, [this](std::uint32_t) { follow_news(); })),
      reader_(std::move(catalogue), [file = news_.get()] { ring(file); }) {
    watch();
    reader_.finish();
    follow_news();
}

void CatalogueFollower::watch() {
    if (!directory_watch_.add(directory_)) retry_.arm(retry_time);
    reader_.request_all();
}

void CatalogueFollower::read_events() {
    for (const DirectoryEvent& event : directory_watch_.read()) {
        if (event.kind == DirectoryEvent::Kind::self_gone) retry_.arm(retry_time);
        if (event.name.empty())
            reader_.request_all();
        else
            changed_.insert(event.name);
    }
    const auto now = EventLoop::Clock::now();
    if (!changed_since_) changed_since_ = now;
    if (now - *changed_since_ >= max_settle_time) return request_changed();
    settled_.arm(settle_time);
}

void CatalogueFollower::request_changed() {
    changed_since_.reset();
    reader_.request_files(std::exchange(changed_, {}));
}

void CatalogueFollower::follow_news() {
    quiet(news_.get());
    std::optional<CatalogueNews> news = reader_.pop_news();
    if (!news) return;
    for (const auto& [file, reason] : news->unreadable)
        log::warning("record '{}' unreadable, ignoring: {}", file, reason);
    if (news->change.is_empty()) return;
    records_ = std::move(news->records);
    counts_ = std::move(news->counts);
    call_(news->change, records_, news->groups);
}

}  // namespace vitrine::player
