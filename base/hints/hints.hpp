#pragma once

#include "base/calendar/day_times.hpp"
#include "base/calendar/weekdays.hpp"

#include <chrono>
#include <optional>
#include <string>

namespace vitrine {

/// The operator's wishes for a file or folder, from its name or from a folder's `.vitrine.toml`. A member
/// without a value was not given. Each member has one entry in the table of hint_words.cpp.
struct Hints {
    std::optional<Period> period;
    std::optional<Hours> hours;
    std::optional<Weekdays> weekdays;
    std::optional<std::chrono::seconds> dwell;  // time on the wall
    std::optional<int> repeat;                  // turns in a round, compared with other files
    std::optional<bool> sound;
    std::optional<std::string> caption;  // a line of text, UTF-8; set over the picture where nothing matters
    std::optional<std::string> code;     // the text of a QR code, UTF-8; drawn in the same way

    bool operator==(const Hints&) const = default;

    bool is_scheduled() const { return period || hours || weekdays; }
};

/// Tells if a file with these hints may be shown now. All times are local civil time: hours that daylight
/// saving repeats count twice, and hours that it skips never come. Hours over midnight belong to the day on
/// which they start.
/// @param now  none: the time is not known; then no file with a schedule may be shown
bool is_open(const Hints& hints, std::optional<std::chrono::local_seconds> now,
             const Holidays& holidays = {});

}  // namespace vitrine
