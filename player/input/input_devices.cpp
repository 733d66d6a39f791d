#include "player/input/input_devices.hpp"

#include "base/system/log.hpp"

#include <sys/epoll.h>

#include <algorithm>
#include <utility>

namespace vitrine::player {

namespace {

constexpr std::size_t most_events = 4096;  // kept while no picture is shown; more are of a broken panel

/// The event with its time since the player's start.
InputEvent counted_from(InputEvent event, std::chrono::nanoseconds start) {
    std::visit([&](auto& one) { one.time -= start; }, event);
    return event;
}

}  // namespace

Visitors::Visitors(EventLoop& loop, const std::string& devices) {
    if (devices == "none") return;
    try {
        touch_ = std::make_unique<Touch>(devices);
        readable_ = loop.watch(touch_->event_fd(), EPOLLIN, [this](std::uint32_t) { read(); });
        read();
    } catch (const std::exception& error) {
        touch_.reset();
        log::warning("input: none: {}", error.what());
    }
}

/// A panel that cannot be read any more is no reason to show nothing.
void Visitors::read() {
    try {
        std::vector<PanelEvent> events = touch_->events();
        if (events_.size() + events.size() <= most_events)
            events_.insert(events_.end(), events.begin(), events.end());
    } catch (const std::exception& error) {
        log::warning("input: no more: {}", error.what());
        readable_ = {};
        return;
    }
    for (const std::string& news : touch_->take_news())
        if (news != std::exchange(told_, news)) log::info("input: {}", news);
}

void Visitors::hand_out(std::span<Screen* const> screens, EventLoop::Clock::time_point start,
                        const std::function<void(const Screen&, InputEvent)>& take) {
    for (const PanelEvent& event : std::exchange(events_, {})) {
        if (screens.empty()) continue;
        const auto named = std::ranges::find_if(
            screens, [&](const Screen* screen) { return screen->name() == event.output; });
        take(named == screens.end() ? *screens.front() : **named,
             counted_from(event.event, start.time_since_epoch()));
    }
}

void Visitors::leave() {
    if (touch_) touch_->leave();
}

void Visitors::come_back() {
    if (touch_) touch_->come_back();
}

}  // namespace vitrine::player
