#include "analyzer/watch/liveness.hpp"

#include "base/system/log.hpp"
#include "base/system/service.hpp"

#include <algorithm>
#include <utility>

namespace vitrine::analyzer {

namespace {

constexpr auto status_rest = std::chrono::seconds(1);        // between two status lines
constexpr auto running_interval = std::chrono::seconds(15);  // the same, where only the time passes

}  // namespace

Liveness::Liveness(EventLoop& loop, std::function<StatusLine()> status)
    : status_(std::move(status)),
      watchdog_(loop.timer([this] { feed_watchdog(); })),
      sending_(loop.timer([this] { send_status(); })) {
    watchdog_.arm(std::chrono::seconds(0));
}

std::optional<std::string> Liveness::overdue(Time now) const {
    const auto earliest =
        std::ranges::min_element(expected_, {}, [](const auto& expected) { return expected.second; });
    if (earliest == expected_.end() || now <= earliest->second + patience) return std::nullopt;
    return earliest->first;
}

void Liveness::feed_watchdog_now() {
    const auto interval = service::watchdog_interval();
    const Time now = EventLoop::Clock::now();
    if (!interval || (fed_ && now < *fed_ + *interval / 4)) return;
    service::feed_watchdog();
    fed_ = now;
    watchdog_.arm(*interval / 2);  // events that wait in the loop meanwhile come first
}

void Liveness::feed_watchdog() {
    const auto interval = service::watchdog_interval();
    if (!interval) return;
    watchdog_.arm(*interval / 2);
    const std::string what = overdue(EventLoop::Clock::now()).value_or("");
    if (!what.empty() && what != told_overdue_) log::error("watchdog not fed: {} is overdue", what);
    told_overdue_ = what;
    if (what.empty()) feed_watchdog_now();
}

void Liveness::send_status_soon() {
    if (!std::exchange(is_sending_, true)) sending_.arm(status_rest);
}

void Liveness::send_status() {
    is_sending_ = false;
    const StatusLine line = status_();
    service::status(line.text);
    if (line.has_running_times) sending_.arm(running_interval);
}

}  // namespace vitrine::analyzer
