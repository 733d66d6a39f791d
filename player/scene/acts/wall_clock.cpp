#include "player/scene/acts/wall_clock.hpp"

#include <algorithm>

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;
using std::chrono::nanoseconds;

constexpr nanoseconds large = 100ms;  // a difference that is made up at once
constexpr int slowness = 100;         // of this share of the time passed, a small difference is made up

nanoseconds whole_seconds(nanoseconds time) {
    return std::chrono::floor<std::chrono::seconds>(time);
}

}  // namespace

WallClock::WallClock(const ClockReading& start)
    : epoch_(whole_seconds(start.real)),
      now_(start.real - epoch_),
      steady_(start.steady),
      is_right_(start.is_right) {}

/// The zero moves by whole seconds where the time would go back or far ahead.
void WallClock::go_to(nanoseconds shared) {
    const nanoseconds passed = shared - epoch_ - now_;
    if (passed < 0ns || passed > 1s) epoch_ += whole_seconds(passed);
    now_ = shared - epoch_;
}

void WallClock::follow(const ClockReading& reading, bool may_jump) {
    const nanoseconds passed = std::max(0ns, reading.steady - steady_);
    steady_ = reading.steady;
    now_ += passed;
    const nanoseconds shared = epoch_ + now_;
    difference_ = reading.real - shared;
    if (!reading.is_right) {
        is_right_ = false;
        return;
    }
    const bool is_large = difference_ > large || difference_ < -large;
    if (is_large && !may_jump) return;
    const nanoseconds most = passed / slowness;
    const nanoseconds step = is_large ? difference_ : std::clamp(difference_, -most, most);
    // at the slowest, time stands still
    if (is_large)
        go_to(shared + step);
    else
        now_ += step;
    difference_ -= step;
    is_right_ = true;
}

}  // namespace vitrine::player
