#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace vitrine {

/// Days from first to last, both included; a side that is missing is open.
struct Period {
    std::optional<std::chrono::local_days> first;
    std::optional<std::chrono::local_days> last;

    friend bool operator==(const Period&, const Period&) = default;
};

/// A time of the day, [from, to) after midnight, at most 24 h; where `to` is not later than `from` it is that
/// of the next day.
struct Hours {
    std::chrono::minutes from{0};
    std::chrono::minutes to{0};

    friend bool operator==(const Hours&, const Hours&) = default;
};

/// What an operator says of how something is shown, in names of files and folders or in a folder's
/// `.vitrine.toml`. What is missing is not said.
struct Hints {
    std::optional<Period> period;
    std::optional<Hours> hours;
    std::optional<std::chrono::seconds> dwell;  // that it stays
    std::optional<int> repeat;                  // times as often as others in a round
    std::optional<bool> sound;

    friend bool operator==(const Hints&, const Hints&) = default;

    bool is_scheduled() const { return period || hours; }
};

/// What is said within what: each kind of hint by itself, the inner one counts.
Hints merged(const Hints& outer, const Hints& inner);

/// Whether it may be shown. All is in local civil time: hours that daylight saving repeats count twice, hours
/// that it leaves out never come. Hours over midnight belong to the day on which they begin.
/// @param now  none: the time is not known; then nothing that is scheduled may be shown
bool is_open(const Hints& hints, std::optional<std::chrono::local_seconds> now);

/// As period_named() reads it: "2026-12-01..2026-12-24".
std::string to_text(const Period& period);

/// As hours_named() reads it: "08:00-18:30".
std::string to_text(const Hours& hours);

/// For the operator: "from 2026-12-01 to 2026-12-24, from 08:00 to 18:00, for 20 seconds, 3 times as often".
/// Empty where nothing is said.
std::string in_words(const Hints& hints);

}  // namespace vitrine
