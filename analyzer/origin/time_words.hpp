#pragma once

#include <chrono>
#include <optional>
#include <string_view>

namespace vitrine::analyzer {

// Times as cameras write them.

/// Parses "2026:12:24" and "2026-12-24". @return  none: there is no such day
std::optional<std::chrono::local_days> day_named(std::string_view text);

/// Parses "2026:12:24 18:30:05" and "2026-12-24T18:30:05", with anything behind it.
/// @return  none: another text, or a time that does not exist
std::optional<std::chrono::local_seconds> civil_time_named(std::string_view text);

/// Parses "+02:00", "-0330" and "Z", up to 14 hours. @return  minutes east of UTC; none: another text
std::optional<std::chrono::minutes> zone_named(std::string_view text);

}  // namespace vitrine::analyzer
