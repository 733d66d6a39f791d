#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

namespace vitrine {

/// Days from first to last, both included; a missing side is open.
struct Period {
    std::optional<std::chrono::local_days> first;
    std::optional<std::chrono::local_days> last;

    bool operator==(const Period&) const = default;
};

/// A time of the day, [from, to) after midnight, at most 24 h. If `to` is not later than `from`, it is a time
/// of the next day.
struct Hours {
    std::chrono::minutes from{0};
    std::chrono::minutes to{0};

    bool operator==(const Hours&) const = default;
};

// Periods and hours as text.

/// Parses "2026-12-01..2026-12-24", "2026-12-01.." or "..2026-12-24".
/// @return  none: another text, a date that does not exist, or the first date is after the last
std::optional<Period> period_named(std::string_view text);

/// The digits that each time must have.
enum class TimePrecision { hour, minute };

/// Parses "08-18" or "08:30-18.00": two digits for the hours, at most "24", and two for the minutes after ':'
/// or '.'.
/// @param min_precision  minute: both times need their minutes
/// @return               none: another text, or both times are the same
std::optional<Hours> hours_named(std::string_view text, TimePrecision min_precision = TimePrecision::hour);

/// "2026-12-24"; empty for no day.
std::string to_text(const std::optional<std::chrono::local_days>& day);

/// A text that period_named() reads: "2026-12-01..2026-12-24".
std::string to_text(const Period& period);

/// "08:00"
std::string to_text(std::chrono::minutes time_of_day);

/// A text that hours_named() reads: "08:00-18:30".
std::string to_text(const Hours& hours);

/// The day of the opening that contains this moment: hours over midnight belong to the day on which they
/// start. None: the moment is outside the hours.
/// @param hours  none: all day
std::optional<std::chrono::local_days> opening_day(const std::optional<Hours>& hours,
                                                   std::chrono::local_seconds now);

}  // namespace vitrine
