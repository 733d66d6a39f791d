#include "player/wall_link/shared_clock.hpp"

#include "base/system/machine.hpp"

namespace vitrine::player {

namespace {

using std::chrono::nanoseconds;

constexpr auto asked_anew = std::chrono::seconds(1);

nanoseconds since_1970() {
    return std::chrono::system_clock::now().time_since_epoch();
}

}  // namespace

SharedClock::SharedClock(WallRole role) : role_(role) {
    if (role_ == WallRole::alone) return;
    is_kept_ = role_ == WallRole::lead || is_clock_kept_right();
    shared_.emplace(read());
}

void SharedClock::begin() {
    start_ = EventLoop::Clock::now();
}

ClockReading SharedClock::read() const {
    return {.steady = EventLoop::Clock::now().time_since_epoch(), .real = since_1970(), .is_right = is_kept_};
}

void SharedClock::follow(bool may_jump) {
    if (!shared_) return;
    read_ = EventLoop::Clock::now();
    if (role_ == WallRole::follow && read_ - asked_ >= asked_anew) {
        is_kept_ = is_clock_kept_right();
        asked_ = read_;
    }
    shared_->follow(read(), may_jump);
}

nanoseconds SharedClock::now() const {
    const auto now = EventLoop::Clock::now();
    return shared_ ? shared_->now() + (now - read_) : now - start_;
}

}  // namespace vitrine::player
