#include "base/hints/hint_words.hpp"

#include <algorithm>
#include <utility>

namespace vitrine {

namespace {

constexpr std::string_view separators = " _";
constexpr int minutes_of_day = 24 * 60;

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// Of so many digits and nothing else; at most nine.
std::optional<int> number(std::string_view text, std::size_t least, std::size_t most) {
    if (text.size() < least || text.size() > most || !std::all_of(text.begin(), text.end(), is_digit))
        return std::nullopt;
    int value = 0;
    for (const char c : text)
        value = value * 10 + (c - '0');
    return value;
}

/// "20s": from 1 to `most`, without a zero before it.
std::optional<int> counted(std::string_view word, char unit, int most) {
    if (word.empty() || word.back() != unit || word.front() == '0') return std::nullopt;
    const auto value = number(word.substr(0, word.size() - 1), 1, 5);
    return value && *value <= most ? value : std::nullopt;
}

std::optional<std::chrono::local_days> date_named(std::string_view text) {
    if (text.size() != 10 || text[4] != '-' || text[7] != '-') return std::nullopt;
    const auto year = number(text.substr(0, 4), 4, 4);
    const auto month = number(text.substr(5, 2), 2, 2);
    const auto day = number(text.substr(8, 2), 2, 2);
    if (!year || !month || !day) return std::nullopt;
    const std::chrono::year_month_day date{std::chrono::year(*year),
                                           std::chrono::month(static_cast<unsigned>(*month)),
                                           std::chrono::day(static_cast<unsigned>(*day))};
    if (!date.ok()) return std::nullopt;
    return std::chrono::local_days(date);
}

struct DayTime {
    int minutes = 0;
    bool is_to_the_minute = false;
};

std::optional<DayTime> time_named(std::string_view text) {
    const auto hours = number(text.substr(0, 2), 2, 2);
    if (!hours) return std::nullopt;
    if (text.size() == 2 && *hours <= 24) return DayTime{.minutes = *hours * 60};
    if (text.size() != 5 || (text[2] != ':' && text[2] != '.')) return std::nullopt;
    const auto minutes = number(text.substr(3), 2, 2);
    if (!minutes || *minutes >= 60) return std::nullopt;
    const int time = *hours * 60 + *minutes;
    if (time > minutes_of_day) return std::nullopt;
    return DayTime{.minutes = time, .is_to_the_minute = true};
}

struct TimeSpan {
    DayTime from, to;
};

std::optional<TimeSpan> span_named(std::string_view text) {
    const std::size_t dash = text.find('-');
    if (dash == std::string_view::npos) return std::nullopt;
    const auto from = time_named(text.substr(0, dash));
    const auto to = time_named(text.substr(dash + 1));
    if (!from || !to || from->minutes == to->minutes || from->minutes == minutes_of_day) return std::nullopt;
    return TimeSpan{*from, *to};
}

Hours hours_of(const TimeSpan& span) {
    return {.from = std::chrono::minutes(span.from.minutes), .to = std::chrono::minutes(span.to.minutes)};
}

std::string_view without_extension(std::string_view name) {
    const std::size_t dot = name.rfind('.');
    if (dot == std::string_view::npos || dot == 0) return name;
    const std::string_view extension = name.substr(dot + 1);
    const bool is_one =
        !extension.empty() && extension.size() <= 5 &&
        std::all_of(extension.begin(), extension.end(), [](char c) { return is_digit(c) || is_letter(c); }) &&
        std::any_of(extension.begin(), extension.end(), is_letter);
    return is_one ? name.substr(0, dot) : name;
}

/// Takes the next word off. Empty at the end.
std::string_view take_word(std::string_view& rest) {
    rest.remove_prefix(std::min(rest.find_first_not_of(separators), rest.size()));
    const std::string_view word = rest.substr(0, rest.find_first_of(separators));
    rest.remove_prefix(word.size());
    return word;
}

/// Sets what was not said yet.
template <typename T> bool say(std::optional<T>& kind, std::optional<T> value) {
    if (!value || kind) return false;
    kind = std::move(value);
    return true;
}

/// "from 2026-12-01", "until 2026-12-24"; both together where they follow each other.
bool take_bound(Hints& hints, std::string_view word, std::string_view& rest) {
    if (word != "from" && word != "until") return false;
    std::string_view after = rest;
    const auto day = date_named(take_word(after));
    if (!day) return false;
    Period period = hints.period.value_or(Period{});
    std::optional<std::chrono::local_days>& side = word == "from" ? period.first : period.last;
    if (side) return false;
    side = day;
    if (period.first && period.last && *period.first > *period.last) return false;
    hints.period = period;
    rest = after;
    return true;
}

bool take_hours(Hints& hints, std::string_view word, NamePart part) {
    const auto span = span_named(word);
    if (!span) return false;
    if (part == NamePart::file && !(span->from.is_to_the_minute && span->to.is_to_the_minute)) return false;
    return say(hints.hours, std::optional(hours_of(*span)));
}

bool take(Hints& hints, std::string_view word, std::string_view& rest, NamePart part) {
    if (word == "mute" || word == "sound") return say(hints.sound, std::optional(word == "sound"));
    if (const auto seconds = counted(word, 's', most_dwell_seconds))
        return say(hints.dwell, std::optional(std::chrono::seconds(*seconds)));
    if (const auto times = counted(word, 'x', most_repeats)) return say(hints.repeat, times);
    return say(hints.period, period_named(word)) || take_hours(hints, word, part) ||
           take_bound(hints, word, rest);
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

std::optional<Hours> hours_named(std::string_view text) {
    const auto span = span_named(text);
    if (!span) return std::nullopt;
    return hours_of(*span);
}

Hints hints_in_name(std::string_view name, NamePart part) {
    std::string_view rest = part == NamePart::file ? without_extension(name) : name;
    Hints hints;
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest))
        if (!take(hints, word, rest, part)) break;
    return hints;
}

}  // namespace vitrine
