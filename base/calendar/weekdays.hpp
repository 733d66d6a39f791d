#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace vitrine {

/// A set of days of the week.
struct Weekdays {
    std::uint8_t days = 0;  // bit 0: Monday, bit 6: Sunday

    bool contains(std::chrono::weekday day) const { return (days >> (day.iso_encoding() - 1) & 1U) != 0; }

    bool operator==(const Weekdays&) const = default;
};

/// Parses days and stretches of days, divided by commas: "Mo-Fr", "Sat,Sun", "Fr-Mo,Mi", "1-5". A day is its
/// English or German name, the first two or three letters of it, or a digit from 1 for Monday to 7. Upper and
/// lower case are alike.
/// @return  none: another text
std::optional<Weekdays> weekdays_named(std::string_view text);

/// True for a text that names a single day, or digits only, which may as well be a part of a name: "So", "1".
bool is_doubtful_weekday(std::string_view text);

/// A text that weekdays_named() reads: "Mo-Fr,Su".
std::string to_text(Weekdays days);

/// "Monday to Friday, Sunday"
std::string in_words(Weekdays days);

/// Days that count as Sundays.
using Holidays = std::set<std::chrono::local_days>;

/// True where this day is one of the days of the week.
bool is_on(Weekdays weekdays, std::chrono::local_days day, const Holidays& holidays = {});

}  // namespace vitrine
