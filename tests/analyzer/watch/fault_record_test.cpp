#include "analyzer/watch/fault_record.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <ctime>

using namespace vitrine;
using namespace vitrine::analyzer;
using namespace std::chrono_literals;

namespace {

const WallClock::time_point noon{std::chrono::sys_days{std::chrono::year(2026) / 11 / 22} + 12h};

MediaRecord unread(FaultOwner owner = FaultOwner::transport) {
    MediaRecord record{.path = "a.jpg", .bytes = 10, .mtime_ns = 1, .reason = "the file cannot be read"};
    record.fault.owner = owner;
    return record;
}

}  // namespace

TEST_CASE("a fault tells since when it lasts, also when it is met again and after a day") {
    ::setenv("TZ", "UTC", 1);
    ::tzset();
    const MediaRecord first = waiting_record(unread(), std::nullopt, noon);
    CHECK(first.state == MediaState::waiting);
    CHECK(first.reason == "since 12:00: the file cannot be read; it is tried again");
    CHECK(first.fault.owner == FaultOwner::transport);

    const MediaRecord again = waiting_record(unread(), first, noon + 1h);
    CHECK(again.reason == first.reason);
    CHECK(waiting_record(unread(), first, noon + 24h).reason ==
          "since 12:00 on 2026-11-22: the file cannot be read; it is tried again");
    CHECK(waiting_record(unread(FaultOwner::machine), first, noon + 1h).reason.starts_with("since 13:00"));
    MediaRecord other = first;
    other.mtime_ns = 2;
    CHECK(waiting_record(unread(), other, noon + 1h).reason.starts_with("since 13:00"));
}

TEST_CASE("a quarantine lasts a day, the next ones of the same content a week") {
    const MediaRecord first = quarantined_record(unread(FaultOwner::file), std::nullopt, noon);
    CHECK(first.state == MediaState::quarantined);
    CHECK(first.fault.until - first.fault.since == 24h);
    const MediaRecord second = quarantined_record(unread(FaultOwner::file), first, noon + 25h);
    CHECK(second.fault.until - second.fault.since == 7 * 24h);
    CHECK(second.fault.quarantines == 2);
    MediaRecord changed = first;
    changed.bytes = 11;
    CHECK(quarantined_record(unread(FaultOwner::file), changed, noon).fault.quarantines == 1);
}
