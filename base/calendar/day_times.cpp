#include "base/calendar/day_times.hpp"

#include "base/calendar/dates.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace vitrine {

namespace {

constexpr int minutes_of_day = 24 * 60;

struct DayTime {
    int minutes = 0;
    TimePrecision precision = TimePrecision::hour;
};

std::optional<DayTime> time_named(std::string_view text) {
    const auto hours = digits_named(text.substr(0, 2), 2);
    if (!hours) return std::nullopt;
    if (text.size() == 2 && *hours <= 24) return DayTime{.minutes = *hours * 60};
    if (text.size() != 5 || (text[2] != ':' && text[2] != '.')) return std::nullopt;
    const auto minutes = digits_named(text.substr(3), 2);
    if (!minutes || *minutes >= 60) return std::nullopt;
    const int time = *hours * 60 + *minutes;
    if (time > minutes_of_day) return std::nullopt;
    return DayTime{.minutes = time, .precision = TimePrecision::minute};
}

}  // namespace

std::optional<Period> period_named(std::string_view text) {
    const std::size_t dots = text.find("..");
    if (dots == std::string_view::npos) return std::nullopt;
    const std::string_view before = text.substr(0, dots);
    const std::string_view after = text.substr(dots + 2);
    const Period period{.first = date_named(before), .last = date_named(after)};
    if (before.empty() && after.empty()) return std::nullopt;
    if ((!before.empty() && !period.first) || (!after.empty() && !period.last)) return std::nullopt;
    if (period.first && period.last && *period.first > *period.last) return std::nullopt;
    return period;
}

std::optional<Hours> hours_named(std::string_view text, TimePrecision min_precision) {
    const std::size_t dash = text.find('-');
    if (dash == std::string_view::npos) return std::nullopt;
    const auto from = time_named(text.substr(0, dash));
    const auto to = time_named(text.substr(dash + 1));
    if (!from || !to || from->precision < min_precision || to->precision < min_precision) return std::nullopt;
    if (from->minutes == to->minutes || from->minutes == minutes_of_day) return std::nullopt;
    return Hours{.from = std::chrono::minutes(from->minutes), .to = std::chrono::minutes(to->minutes)};
}

std::string to_text(const std::optional<std::chrono::local_days>& day) {
    if (!day) return {};
    const std::chrono::year_month_day date(*day);
    return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(date.year()),
                       static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()));
}

std::string to_text(const Period& period) {
    return to_text(period.first) + ".." + to_text(period.last);
}

std::string to_text(std::chrono::minutes time_of_day) {
    return fmt::format("{:02}:{:02}", time_of_day.count() / 60, time_of_day.count() % 60);
}

std::string to_text(const Hours& hours) {
    return to_text(hours.from) + "-" + to_text(hours.to);
}

std::optional<std::chrono::local_days> opening_day(const std::optional<Hours>& hours,
                                                   std::chrono::local_seconds now) {
    const auto day = std::chrono::floor<std::chrono::days>(now);
    if (!hours) return day;
    const std::chrono::seconds time = now - day;
    const bool is_over_midnight = hours->to <= hours->from;
    if (time >= hours->from && (is_over_midnight || time < hours->to)) return day;
    if (is_over_midnight && time < hours->to) return day - std::chrono::days(1);
    return std::nullopt;
}

}  // namespace vitrine
