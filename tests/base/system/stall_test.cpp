#include "base/system/stall.hpp"

#include <doctest/doctest.h>

#include <optional>

using namespace vitrine;
using namespace std::chrono_literals;

namespace {

/// When a stall of twenty seconds is found in work that computes for so long in each second; none in ten
/// minutes.
std::optional<std::chrono::seconds> found(std::chrono::milliseconds a_second,
                                          std::chrono::seconds until = 10min) {
    Stall stall(20s);
    Stall::Duration busy = 0s;
    for (std::chrono::seconds now = 100s; now < 700s; now += 1s) {
        if (stall.is_hanging(now, busy)) return now - 100s;
        if (now - 100s < until) busy += a_second;
    }
    return std::nullopt;
}

}  // namespace

TEST_CASE("what computes hardly anything has stalled, what computes slowly has not") {
    CHECK(found(0ms) == 20s);
    CHECK_FALSE(found(1000ms));
    CHECK_FALSE(found(5ms));  // on a machine with much else to do
}

TEST_CASE("a stall is counted from when it last computed") {
    CHECK(found(500ms, 60s) == 80s);
}

TEST_CASE("this process stalls at once where it may not wait") {
    CHECK(Stall(0s).is_hanging());
    CHECK_FALSE(Stall(1h).is_hanging());
}
