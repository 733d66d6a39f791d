#pragma once

#include "base/calendar/day_times.hpp"
#include "base/calendar/weekdays.hpp"

#include <chrono>
#include <optional>
#include <string_view>
#include <vector>

namespace vitrine {

/// Hours on some days of the week. Local civil time: an hour that daylight saving repeats counts twice, and
/// one that it skips never comes.
struct DayWindow {
    std::optional<Weekdays> weekdays;  // none: every day
    std::optional<Hours> hours;        // none: all day. Those over midnight belong to the day they start on
    double share = 1;                  // of the light, (0, 1]; only in dim_windows_named()

    bool operator==(const DayWindow&) const = default;
};

/// Parses "Mo-Fr 08:00-18:30, Sat 10-14", "08-18" or "Mo-Fr". A comma without a space divides days. No window
/// is a list, too.
/// @return  none: another text
std::optional<std::vector<DayWindow>> day_windows_named(std::string_view text);

/// Parses windows that each end with a share: "20:00-06:00 40%, Sun 18-20 60%". 1 to 100 per cent.
/// @return  none: another text
std::optional<std::vector<DayWindow>> dim_windows_named(std::string_view text);

/// The first window that contains this moment; nullptr: there is none.
/// @param holidays  count as Sundays
const DayWindow* find_window(const std::vector<DayWindow>& windows, std::chrono::local_seconds now,
                             const Holidays& holidays = {});

}  // namespace vitrine
