#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <set>
#include <string_view>

namespace vitrine {

// Days as text.

/// Parses exactly `digits` digits. @return  none: another text
std::optional<int> digits_named(std::string_view text, std::size_t digits);

/// Parses "2026-12-24". @return  none: there is no such date
std::optional<std::chrono::local_days> date_named(std::string_view text);

/// Parses dates divided by spaces or commas: "2026-12-25, 2026-12-26". No date is a list, too.
/// @return  none: another text, or a date that does not exist
std::optional<std::set<std::chrono::local_days>> dates_named(std::string_view text);

/// True for the same day in another year. In years without a 29 February the 28th stands for it, too.
bool is_anniversary(std::chrono::local_days day, std::chrono::local_days today);

}  // namespace vitrine
