#include "player/input/input_devices.hpp"

#include "base/system/log.hpp"

#include <sys/epoll.h>

#include <algorithm>
#include <utility>

namespace vitrine::player {

namespace {

constexpr std::size_t max_events = 4096;  // limit while no frame is shown; only a broken panel sends more

/// The event with its time counted from the player's start.
InputEvent counted_from(InputEvent event, std::chrono::nanoseconds start) {
    std::visit([&](auto& one) { one.time -= start; }, event);
    return event;
}

}  // namespace

InputDevices::InputDevices(EventLoop& loop, const std::string& devices) {
    if (devices == "none") return;
    try {
        touch_ = std::make_unique<Touch>(devices);
        readable_ = loop.watch(touch_->event_fd(), EPOLLIN, [this](std::uint32_t) { read(); });
        read();
    } catch (const std::exception& error) {
        touch_.reset();
        log::warning("input: no device can be used: {}", error.what());
    }
}

/// Reads the input. If the devices cannot be read any more, the wall goes on without input.
void InputDevices::read() {
    try {
        std::vector<PanelEvent> events = touch_->read_events();
        if (events_.size() + events.size() <= max_events)
            events_.insert(events_.end(), events.begin(), events.end());
    } catch (const std::exception& error) {
        log::warning("input: devices cannot be read any more: {}", error.what());
        readable_ = {};
        return;
    }
    for (const std::string& news : touch_->take_news())
        if (news != std::exchange(logged_, news)) log::info("input: {}", news);
}

void InputDevices::deliver_input(std::span<Screen* const> screens, EventLoop::Clock::time_point start,
                                 const Call& call) {
    for (const PanelEvent& event : std::exchange(events_, {})) {
        if (screens.empty()) continue;
        const auto named = std::ranges::find_if(
            screens, [&](const Screen* screen) { return screen->name() == event.output; });
        call(named == screens.end() ? *screens.front() : **named,
             counted_from(event.event, start.time_since_epoch()));
    }
}

void InputDevices::suspend() {
    if (touch_) touch_->suspend();
}

void InputDevices::resume() {
    if (touch_) touch_->resume();
}

}  // namespace vitrine::player
