#include "analyzer/watch/fault_record.hpp"

#include "base/state/blame.hpp"
#include "base/system/machine.hpp"

#include <fmt/format.h>

namespace vitrine::analyzer {

namespace {

std::chrono::seconds whole_seconds(WallClock::time_point time) {
    return std::chrono::floor<std::chrono::seconds>(time.time_since_epoch());
}

/// "14:02", and the day where that is not today's: "14:02 on 2026-11-21".
std::string moment_in_words(std::chrono::seconds since, WallClock::time_point now) {
    using std::chrono::days;
    const auto local = local_time(WallClock::time_point(since));
    const auto day = std::chrono::floor<days>(local);
    const std::chrono::hh_mm_ss time(local - day);
    std::string words = fmt::format("{:02}:{:02}", time.hours().count(), time.minutes().count());
    if (std::chrono::floor<days>(local_time(now)) == day) return words;
    const std::chrono::year_month_day date(day);
    return words + fmt::format(" on {}-{:02}-{:02}", static_cast<int>(date.year()),
                               static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()));
}

}  // namespace

bool is_same_content(const MediaRecord& a, const MediaRecord& b) {
    return a.bytes == b.bytes && a.mtime_ns == b.mtime_ns;
}

MediaRecord waiting_record(MediaRecord record, const std::optional<MediaRecord>& known,
                           WallClock::time_point now) {
    record.state = MediaState::waiting;
    record.fault.since = whole_seconds(now);
    const bool goes_on = known && is_same_content(*known, record) && known->state == MediaState::waiting &&
                         known->fault.owner == record.fault.owner &&
                         known->fault.since > std::chrono::seconds(0);
    if (goes_on) record.fault.since = known->fault.since;
    record.reason = fmt::format("since {}: {}; it is tried again", moment_in_words(record.fault.since, now),
                                record.reason);
    return record;
}

MediaRecord quarantined_record(MediaRecord record, const std::optional<MediaRecord>& known,
                               WallClock::time_point now) {
    record.state = MediaState::quarantined;
    record.fault = {.owner = FaultOwner::file, .since = whole_seconds(now)};
    if (known && is_same_content(*known, record)) record.fault.quarantines = known->fault.quarantines;
    ++record.fault.quarantines;
    record.fault.until = record.fault.since + quarantine_time(record.fault.quarantines);
    record.reason += "; it is tried again after " + moment_in_words(record.fault.until, now);
    return record;
}

}  // namespace vitrine::analyzer
