#include "base/hints/hints.hpp"

#include <fmt/format.h>

#include <vector>

namespace vitrine {

using namespace std::chrono_literals;

namespace {

template <typename T>
std::optional<T> inner_of(const std::optional<T>& outer, const std::optional<T>& inner) {
    return inner ? inner : outer;
}

std::string text_of(const std::optional<std::chrono::local_days>& day) {
    if (!day) return {};
    const std::chrono::year_month_day date(*day);
    return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(date.year()),
                       static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()));
}

std::string text_of(std::chrono::minutes time) {
    return fmt::format("{:02}:{:02}", time.count() / 60, time.count() % 60);
}

/// The day to which this moment counts; none: it is not within the hours.
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

}  // namespace

Hints merged(const Hints& outer, const Hints& inner) {
    return {.period = inner_of(outer.period, inner.period),
            .hours = inner_of(outer.hours, inner.hours),
            .dwell = inner_of(outer.dwell, inner.dwell),
            .repeat = inner_of(outer.repeat, inner.repeat),
            .sound = inner_of(outer.sound, inner.sound)};
}

bool is_open(const Hints& hints, std::optional<std::chrono::local_seconds> now) {
    if (!hints.is_scheduled()) return true;
    if (!now) return false;
    const auto day = day_of(hints.hours, *now);
    if (!day) return false;
    if (!hints.period) return true;
    return (!hints.period->first || *day >= *hints.period->first) &&
           (!hints.period->last || *day <= *hints.period->last);
}

std::string to_text(const Period& period) {
    return text_of(period.first) + ".." + text_of(period.last);
}

std::string to_text(const Hours& hours) {
    return text_of(hours.from) + "-" + text_of(hours.to);
}

std::string in_words(const Hints& hints) {
    std::vector<std::string> words;
    if (hints.period) {
        const Period& period = *hints.period;
        if (period.first && period.first == period.last)
            words.push_back("on " + text_of(period.first));
        else if (period.first && period.last)
            words.push_back("from " + text_of(period.first) + " to " + text_of(period.last));
        else
            words.push_back(period.first ? "from " + text_of(period.first) : "until " + text_of(period.last));
    }
    if (hints.hours)
        words.push_back("from " + text_of(hints.hours->from) + " to " + text_of(hints.hours->to));
    if (hints.dwell) words.push_back(fmt::format("for {} seconds", hints.dwell->count()));
    if (hints.repeat) words.push_back(fmt::format("{} times as often", *hints.repeat));
    if (hints.sound) words.emplace_back(*hints.sound ? "with sound" : "without sound");
    return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace vitrine
