#include "base/hints/hint_words.hpp"

#include "base/calendar/dates.hpp"
#include "base/calendar/day_times.hpp"
#include "base/hints/caption.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace vitrine {

namespace {

constexpr std::string_view separators = " _";

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
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

/// Parses "20s": a number from 1 to `max` without a leading zero, then the unit.
std::optional<int> number_with_unit(std::string_view word, char unit, int max) {
    constexpr std::size_t max_digits = 5;
    if (word.empty() || word.back() != unit || word.front() == '0') return std::nullopt;
    word.remove_suffix(1);
    if (word.empty() || word.size() > max_digits || !std::all_of(word.begin(), word.end(), is_digit))
        return std::nullopt;
    int value = 0;
    for (const char c : word)
        value = value * 10 + (c - '0');
    return value <= max ? std::optional(value) : std::nullopt;
}

std::optional<int> number_in(const HintValue& value, int max) {
    const auto* number = std::get_if<std::int64_t>(&value);
    if (number == nullptr || *number < 1 || *number > max) return std::nullopt;
    return static_cast<int>(*number);
}

std::string_view text_in(const HintValue& value) {
    const auto* text = std::get_if<std::string>(&value);
    return text != nullptr ? std::string_view(*text) : std::string_view();
}

/// Sets a member from a value. @return  false if there is no value
template <typename T> bool assigned(std::optional<T>& member, const std::optional<T>& value) {
    if (value) member = value;
    return value.has_value();
}

/// Sets a member from a word, if it was not set before. @return  false if there is no value, or it was set
/// before
template <typename T> bool said(std::optional<T>& member, const std::optional<T>& value) {
    return !member && assigned(member, value);
}

template <auto member> void merge(Hints& outer, const Hints& inner) {
    if (inner.*member) outer.*member = inner.*member;
}

/// Reads "from 2026-12-01" and "until 2026-12-24", also both after each other.
bool read_bound(Hints& hints, std::string_view word, NameWords& words) {
    if (word != "from" && word != "until") return false;
    NameWords after = words;
    const auto day = date_named(after.next());
    if (!day) return false;
    Period period = hints.period.value_or(Period{});
    std::optional<std::chrono::local_days>& side = word == "from" ? period.first : period.last;
    if (side) return false;
    side = day;
    if (period.first && period.last && *period.first > *period.last) return false;
    hints.period = period;
    words = after;
    return true;
}

std::string period_in_words(const Hints& hints) {
    const Period& period = *hints.period;
    if (period.first && period.first == period.last) return "on " + to_text(period.first);
    if (period.first && period.last) return "from " + to_text(period.first) + " to " + to_text(period.last);
    return period.first ? "from " + to_text(period.first) : "until " + to_text(period.last);
}

constexpr HintWord period_word{
    .key = "period",
    .allowed = R"(days like "2026-12-01..2026-12-24", "2026-12-01.." or "..2026-12-24")",
    .assign = [](Hints& h, const HintValue& v) { return assigned(h.period, period_named(text_in(v))); },
    .value = [](const Hints& h) -> std::optional<HintValue> {
        return h.period ? std::optional(to_text(*h.period)) : std::nullopt;
    },
    .read = [](Hints& h, std::string_view word,
               NameWords& words) { return said(h.period, period_named(word)) || read_bound(h, word, words); },
    .in_words = &period_in_words,
    .merge = &merge<&Hints::period>};

constexpr HintWord hours_word{
    .key = "hours",
    .allowed = R"(times like "08-18", "22-06" or "08:30-18:00")",
    .assign = [](Hints& h, const HintValue& v) { return assigned(h.hours, hours_named(text_in(v))); },
    .value = [](const Hints& h) -> std::optional<HintValue> {
        return h.hours ? std::optional(to_text(*h.hours)) : std::nullopt;
    },
    .read =
        [](Hints& h, std::string_view word, NameWords& words) {
            const bool is_file = words.part == NamePart::file;
            return said(h.hours, hours_named(word, is_file ? TimePrecision::minute : TimePrecision::hour));
        },
    .in_words =
        [](const Hints& h) { return "from " + to_text(h.hours->from) + " to " + to_text(h.hours->to); },
    .merge = &merge<&Hints::hours>};

/// Days are a hint if they cannot be a part of the name: "Mo-Fr", "Sat,Sun". A single day is one if a period
/// or hours follow, and also, with its whole name, as the whole name of a folder.
bool read_weekdays(Hints& hints, std::string_view word, NameWords& words) {
    if (words.part == NamePart::file && is_digit(word.front())) return false;
    if (is_doubtful_weekday(word)) {
        constexpr std::size_t whole_name = 6;  // letters of the shortest
        NameWords after = words;
        const std::string_view next = after.next();
        const bool is_timed = period_named(next) || hours_named(next);
        const bool is_all = next.empty() && words.part == NamePart::folder && word.size() >= whole_name;
        if (!is_timed && !is_all) return false;
    }
    return said(hints.weekdays, weekdays_named(word));
}

constexpr HintWord weekdays_word{
    .key = "weekdays",
    .allowed = R"(days like "Mo-Fr", "Sat,Sun" or "1-5")",
    .assign = [](Hints& h, const HintValue& v) { return assigned(h.weekdays, weekdays_named(text_in(v))); },
    .value = [](const Hints& h) -> std::optional<HintValue> {
        return h.weekdays ? std::optional(to_text(*h.weekdays)) : std::nullopt;
    },
    .read = &read_weekdays,
    .in_words = [](const Hints& h) { return "on " + in_words(*h.weekdays); },
    .merge = &merge<&Hints::weekdays>};

std::optional<std::chrono::seconds> seconds_of(std::optional<int> number) {
    return number ? std::optional(std::chrono::seconds(*number)) : std::nullopt;
}

constexpr HintWord seconds_word{
    .key = "seconds",
    .allowed = "a whole number from 1 to 86400",
    .assign =
        [](Hints& h, const HintValue& v) {
            return assigned(h.dwell, seconds_of(number_in(v, max_dwell_seconds)));
        },
    .value = [](const Hints& h) -> std::optional<HintValue> {
        return h.dwell ? std::optional(std::int64_t{h.dwell->count()}) : std::nullopt;
    },
    .read =
        [](Hints& h, std::string_view word, NameWords& /*words*/) {
            return said(h.dwell, seconds_of(number_with_unit(word, 's', max_dwell_seconds)));
        },
    .in_words = [](const Hints& h) { return fmt::format("for {} seconds", h.dwell->count()); },
    .merge = &merge<&Hints::dwell>};

constexpr HintWord repeat_word{
    .key = "repeat",
    .allowed = "a whole number from 1 to 20",
    .assign = [](Hints& h, const HintValue& v) { return assigned(h.repeat, number_in(v, max_repeats)); },
    .value = [](const Hints& h) -> std::optional<HintValue> {
        return h.repeat ? std::optional(std::int64_t{*h.repeat}) : std::nullopt;
    },
    .read = [](Hints& h, std::string_view word,
               NameWords& /*words*/) { return said(h.repeat, number_with_unit(word, 'x', max_repeats)); },
    .in_words = [](const Hints& h) { return fmt::format("{} times as often", *h.repeat); },
    .merge = &merge<&Hints::repeat>};

constexpr HintWord sound_word{
    .key = "sound",
    .allowed = "true or false",
    .assign =
        [](Hints& h, const HintValue& v) {
            const bool* is_on = std::get_if<bool>(&v);
            return is_on != nullptr && assigned(h.sound, std::optional(*is_on));
        },
    .value = [](const Hints& h) -> std::optional<HintValue> { return h.sound; },
    .read =
        [](Hints& h, std::string_view word, NameWords& /*words*/) {
            return (word == "sound" || word == "mute") && said(h.sound, std::optional(word == "sound"));
        },
    .in_words = [](const Hints& h) { return std::string(*h.sound ? "with sound" : "without sound"); },
    .merge = &merge<&Hints::sound>};

constexpr HintWord caption_word{
    .key = "caption",
    .allowed = "a text of at most 500 bytes",
    .assign =
        [](Hints& h, const HintValue& v) {
            const std::string* text = std::get_if<std::string>(&v);
            const CaptionText read = text != nullptr ? caption_text(*text) : CaptionText{};
            return text != nullptr && read.fault.empty() && assigned(h.caption, std::optional(read.text));
        },
    .value = [](const Hints& h) -> std::optional<HintValue> { return h.caption; },
    .read = [](Hints& /*h*/, std::string_view /*word*/, NameWords& /*words*/) { return false; },
    .in_words = [](const Hints& h) { return fmt::format("with the caption '{}'", *h.caption); },
    .merge = &merge<&Hints::caption>};

constexpr HintWord code_word{
    .key = "qr",
    .allowed = "a text of 1 to 250 bytes",
    .assign =
        [](Hints& h, const HintValue& v) {
            const CaptionText read = code_text(text_in(v));
            return read.fault.empty() && assigned(h.code, std::optional(read.text));
        },
    .value = [](const Hints& h) -> std::optional<HintValue> { return h.code; },
    .read = [](Hints& /*h*/, std::string_view /*word*/, NameWords& /*words*/) { return false; },
    .in_words = [](const Hints& h) { return fmt::format("with the QR code '{}'", *h.code); },
    .merge = &merge<&Hints::code>};

constexpr std::array table{period_word, weekdays_word, hours_word,   seconds_word,
                           repeat_word, sound_word,    caption_word, code_word};

/// A name taken apart: the hints that it begins with, and what follows them.
struct NamedHints {
    Hints hints;
    std::string_view name;  // without separators around it; empty: the name has only hints
};

NamedHints named_hints(std::string_view name, NamePart part) {
    NameWords words{.rest = part == NamePart::file ? without_extension(name) : name, .part = part};
    NamedHints named;
    const auto reads = [&](std::string_view word) {
        return std::any_of(table.begin(), table.end(),
                           [&](const HintWord& one) { return one.read(named.hints, word, words); });
    };
    while (true) {
        const std::string_view before = words.rest;
        const std::string_view word = words.next();
        if (!word.empty() && reads(word)) continue;
        named.name = before.substr(0, before.find_last_not_of(separators) + 1);
        named.name.remove_prefix(std::min(named.name.find_first_not_of(separators), named.name.size()));
        return named;
    }
}

}  // namespace

std::string_view NameWords::next() {
    rest.remove_prefix(std::min(rest.find_first_not_of(separators), rest.size()));
    const std::string_view word = rest.substr(0, rest.find_first_of(separators));
    rest.remove_prefix(word.size());
    return word;
}

std::span<const HintWord> hint_words() {
    return table;
}

Hints hints_in_name(std::string_view name, NamePart part) {
    return named_hints(name, part).hints;
}

std::string plain_name(std::string_view name, NamePart part) {
    std::string_view rest = named_hints(name, part).name;
    std::size_t digits = 0;
    while (digits < rest.size() && is_digit(rest[digits]))
        ++digits;
    constexpr std::size_t max_digits = 3;  // of a number for ordering; a year is a part of the name
    const std::size_t begin = rest.find_first_not_of(" _.-", digits);
    if (digits > 0 && digits <= max_digits && begin > digits && begin < rest.size())
        rest.remove_prefix(begin);
    std::string text(rest);
    std::ranges::replace(text, '_', ' ');
    return text;
}

std::string shown_folder_name(std::string_view path) {
    const std::size_t slash = path.rfind('/');
    const std::string_view name = slash == std::string_view::npos ? path : path.substr(slash + 1);
    const std::string plain = plain_name(name, NamePart::folder);
    return plain.empty() ? std::string(name) : plain;
}

std::string caption_of(const CaptionSources& sources) {
    std::string text(sources.written);
    if (text.empty()) text = caption_text(sources.own).text;
    if (text.empty() && !sources.path.empty()) {
        const std::string_view name = sources.path.substr(sources.path.rfind('/') + 1);
        text = caption_text(plain_name(name, NamePart::file)).text;
    }
    if (!sources.day) return text;
    const auto year = static_cast<int>(std::chrono::year_month_day(*sources.day).year());
    return text.empty() ? std::to_string(year) : fmt::format("{} · {}", year, text);
}

Hints merged(const Hints& outer, const Hints& inner) {
    Hints hints = outer;
    for (const HintWord& word : table)
        word.merge(hints, inner);
    return hints;
}

std::string in_words(const Hints& hints) {
    std::string text;
    for (const HintWord& word : table)
        if (word.value(hints)) text += (text.empty() ? "" : ", ") + word.in_words(hints);
    return text;
}

}  // namespace vitrine
