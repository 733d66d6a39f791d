#include "base/hints/hints.hpp"

namespace vitrine {

namespace {

bool is_within(const Period& period, std::chrono::local_days day) {
    return (!period.first || day >= *period.first) && (!period.last || day <= *period.last);
}

}  // namespace

bool is_open(const Hints& hints, std::optional<std::chrono::local_seconds> now, const Holidays& holidays) {
    if (!hints.is_scheduled()) return true;
    if (!now) return false;
    const auto day = opening_day(hints.hours, *now);
    return day && (!hints.period || is_within(*hints.period, *day)) &&
           (!hints.weekdays || is_on(*hints.weekdays, *day, holidays));
}

}  // namespace vitrine
