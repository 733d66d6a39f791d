#pragma once

#include "base/hints/hints.hpp"

#include <optional>
#include <string_view>

// How hints are written. A word counts only where it is exactly one of these; everything else is a name.
//
//     2026-12-01..2026-12-24   2026-12-01..   ..2026-12-24   from 2026-12-01   until 2026-12-24
//     08-18   22-06   08:30-18:00   08.30-18.00
//     20s   3x   mute   sound

namespace vitrine {

constexpr int most_dwell_seconds = 86400;
constexpr int most_repeats = 20;

/// Dates that exist, the first not after the last. Nothing where it is none.
std::optional<Period> period_named(std::string_view text);

/// Two digits for hours, after ':' or '.' two for minutes; until "24" at most. Nothing where both are the
/// same.
std::optional<Hours> hours_named(std::string_view text);

enum class NamePart { folder, file };

/// The hints that a name begins with, divided by spaces or '_'. They end at the first word that is none, or
/// whose kind was there before. An extension does not count.
///
/// "12-14 team.jpg" is no hint: in the names of files hours need their minutes.
/// @param name  one folder or file without its path, any bytes
Hints hints_in_name(std::string_view name, NamePart part);

}  // namespace vitrine
