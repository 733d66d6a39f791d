#pragma once

#include "base/state/record.hpp"

#include <chrono>
#include <optional>

namespace vitrine::analyzer {

using WallClock = std::chrono::system_clock;

/// True where both records are about the same bytes of a file.
bool is_same_content(const MediaRecord& a, const MediaRecord& b);

/// The record of a file that waits because something else is at fault. Its reason tells since when.
/// @param known  the record in the catalogue, which may tell of the same fault
MediaRecord waiting_record(MediaRecord record, const std::optional<MediaRecord>& known,
                           WallClock::time_point now);

/// The record of a file that is quarantined: for a day, from the second time on for a week.
/// @param known  the record in the catalogue, which may tell of an earlier quarantine
MediaRecord quarantined_record(MediaRecord record, const std::optional<MediaRecord>& known,
                               WallClock::time_point now);

}  // namespace vitrine::analyzer
