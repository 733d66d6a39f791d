#include "base/calendar/weekdays.hpp"

#include "base/state/path_text.hpp"

#include <algorithm>
#include <array>

namespace vitrine {

namespace {

constexpr unsigned week = 7;  // days

struct DayNames {
    std::string_view english;  // its first two and three letters are names, too
    std::string_view german;
    std::string_view other_german;
};

constexpr std::array<DayNames, week> day_names{{{"monday", "montag", {}},
                                                {"tuesday", "dienstag", {}},
                                                {"wednesday", "mittwoch", {}},
                                                {"thursday", "donnerstag", {}},
                                                {"friday", "freitag", {}},
                                                {"saturday", "samstag", "sonnabend"},
                                                {"sunday", "sonntag", {}}}};

bool names_day(std::string_view text, const DayNames& names) {
    const bool is_short = text.size() == 2 || text.size() == 3;
    return text == names.english || text == names.german || text == names.other_german ||
           (is_short &&
            (names.english.starts_with(text) || (text.size() == 2 && names.german.starts_with(text))));
}

/// 0 for Monday, 6 for Sunday.
std::optional<unsigned> day_named(std::string_view text) {
    if (text.size() == 1 && text[0] >= '1' && text[0] <= '7') return static_cast<unsigned>(text[0] - '1');
    const std::string name = lower_case(text);
    const auto found =
        std::ranges::find_if(day_names, [&](const DayNames& names) { return names_day(name, names); });
    if (name.empty() || found == day_names.end()) return std::nullopt;
    return static_cast<unsigned>(found - day_names.begin());
}

/// The days of "Mo-Fr" or "Mo" as bits; 0: another text.
std::uint8_t stretch_named(std::string_view text) {
    const std::size_t dash = text.find('-');
    const auto first = day_named(text.substr(0, dash));
    const auto last = dash == std::string_view::npos ? first : day_named(text.substr(dash + 1));
    if (!first || !last || (dash != std::string_view::npos && *first == *last)) return 0;
    unsigned days = 1U << *last;
    for (unsigned day = *first; day != *last; day = (day + 1) % week)
        days |= 1U << day;
    return static_cast<std::uint8_t>(days);
}

/// Joins the stretches of consecutive days, each of which `stretch` puts into words by its first and last
/// day.
template <typename Stretch> std::string joined(Weekdays days, std::string_view comma, Stretch stretch) {
    std::string text;
    for (unsigned day = 0; day < week; ++day) {
        if ((days.days >> day & 1U) == 0) continue;
        unsigned last = day;
        while (last + 1 < week && (days.days >> (last + 1) & 1U) != 0)
            ++last;
        if (!text.empty()) text += comma;
        text += stretch(day, last);
        day = last;
    }
    return text;
}

std::string capitalised(std::string_view name) {
    std::string text(name);
    text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
}

}  // namespace

std::optional<Weekdays> weekdays_named(std::string_view text) {
    Weekdays result;
    for (std::size_t comma = 0; comma != std::string_view::npos;) {
        comma = text.find(',');
        const std::uint8_t days = stretch_named(text.substr(0, comma));
        if (days == 0) return std::nullopt;
        result.days |= days;
        if (comma != std::string_view::npos) text.remove_prefix(comma + 1);
    }
    return result;
}

bool is_doubtful_weekday(std::string_view text) {
    return text.find_first_of("-,") == std::string_view::npos ||
           (text.find_first_not_of("1234567,") == std::string_view::npos);
}

std::string to_text(Weekdays days) {
    const auto name = [](unsigned day) { return capitalised(day_names.at(day).english.substr(0, 2)); };
    return joined(days, ",", [&](unsigned first, unsigned last) {
        return first == last ? name(first) : name(first) + "-" + name(last);
    });
}

std::string in_words(Weekdays days) {
    const auto name = [](unsigned day) { return capitalised(day_names.at(day).english); };
    return joined(days, ", ", [&](unsigned first, unsigned last) {
        return first == last ? name(first) : name(first) + " to " + name(last);
    });
}

bool is_on(Weekdays weekdays, std::chrono::local_days day, const Holidays& holidays) {
    return weekdays.contains(holidays.contains(day) ? std::chrono::Sunday : std::chrono::weekday(day));
}

}  // namespace vitrine
