#pragma once

#include "base/hints/hints.hpp"

#include <string>
#include <string_view>

namespace vitrine {

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

}  // namespace vitrine
