#include "base/calendar/dates.hpp"

#include <algorithm>

namespace vitrine {

std::optional<int> digits_named(std::string_view text, std::size_t digits) {
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    if (text.size() != digits || !std::all_of(text.begin(), text.end(), is_digit)) return std::nullopt;
    int value = 0;
    for (const char c : text)
        value = value * 10 + (c - '0');
    return value;
}

std::optional<std::chrono::local_days> date_named(std::string_view text) {
    if (text.size() != 10 || text[4] != '-' || text[7] != '-') return std::nullopt;
    const auto year = digits_named(text.substr(0, 4), 4);
    const auto month = digits_named(text.substr(5, 2), 2);
    const auto day = digits_named(text.substr(8, 2), 2);
    if (!year || !month || !day) return std::nullopt;
    const std::chrono::year_month_day date{std::chrono::year(*year),
                                           std::chrono::month(static_cast<unsigned>(*month)),
                                           std::chrono::day(static_cast<unsigned>(*day))};
    if (!date.ok()) return std::nullopt;
    return std::chrono::local_days(date);
}

std::optional<std::set<std::chrono::local_days>> dates_named(std::string_view text) {
    constexpr std::string_view dividers = " ,";
    std::set<std::chrono::local_days> dates;
    for (std::size_t begin = 0;
         (begin = text.find_first_not_of(dividers, begin)) != std::string_view::npos;) {
        const std::size_t end = std::min(text.find_first_of(dividers, begin), text.size());
        const auto date = date_named(text.substr(begin, end - begin));
        if (!date) return std::nullopt;
        dates.insert(*date);
        begin = end;
    }
    return dates;
}

bool is_anniversary(std::chrono::local_days day, std::chrono::local_days today) {
    const std::chrono::year_month_day now(today), then(day);
    if (now.year() == then.year() || now.month() != then.month()) return false;
    constexpr std::chrono::day leap{29}, last{28};
    const bool is_leap_day = then.month() == std::chrono::February && then.day() == leap;
    return now.day() == (is_leap_day && !now.year().is_leap() ? last : then.day());
}

}  // namespace vitrine
