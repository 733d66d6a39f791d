#include "base/system/stall.hpp"

#include <ctime>

namespace vitrine {

namespace {

constexpr Stall::Duration next_to_nothing = std::chrono::milliseconds(20);

Stall::Duration time_of(clockid_t clock) {
    timespec time{};
    ::clock_gettime(clock, &time);
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

}  // namespace

bool Stall::is_hanging(Duration now, Duration busy) {
    if (since_.count() < 0 || busy - busy_ > next_to_nothing) {
        since_ = now;
        busy_ = busy;
    }
    return now - since_ >= patience_;
}

bool Stall::is_hanging() {
    return is_hanging(time_of(CLOCK_MONOTONIC), time_of(CLOCK_PROCESS_CPUTIME_ID));
}

}  // namespace vitrine
