#include "base/hints/hints.hpp"

namespace vitrine {

namespace {

/// The day of the opening that contains this moment. None: the moment is outside the hours.
std::optional<std::chrono::local_days> day_of(const std::optional<Hours>& hours,
                                              std::chrono::local_seconds now) {
    const auto day = std::chrono::floor<std::chrono::days>(now);
    if (!hours) return day;
    const std::chrono::seconds time = now - day;
    const bool is_over_midnight = hours->to <= hours->from;
    if (time >= hours->from && (is_over_midnight || time < hours->to)) return day;
    if (is_over_midnight && time < hours->to) return day - std::chrono::days(1);
    return std::nullopt;
}

bool is_within(const Period& period, std::chrono::local_days day) {
    return (!period.first || day >= *period.first) && (!period.last || day <= *period.last);
}

bool is_on(Weekdays weekdays, std::chrono::local_days day, const Holidays& holidays) {
    return weekdays.contains(holidays.contains(day) ? std::chrono::Sunday : std::chrono::weekday(day));
}

}  // namespace

bool is_open(const Hints& hints, std::optional<std::chrono::local_seconds> now, const Holidays& holidays) {
    if (!hints.is_scheduled()) return true;
    if (!now) return false;
    const auto day = day_of(hints.hours, *now);
    return day && (!hints.period || is_within(*hints.period, *day)) &&
           (!hints.weekdays || is_on(*hints.weekdays, *day, holidays));
}

}  // namespace vitrine
