#pragma once

#include "analyzer/status/status_report.hpp"

#include <string>

namespace vitrine::analyzer {

StateCounts counts_of(const StatusReport& report);

/// "27 files: 24 ready, 2 waiting, 1 unsupported"
std::string summary(const StateCounts& counts);

/// "ready, from 08:00 to 18:00. It is on the wall.", "waiting since 2026-11-21 14:05: half of the picture is
/// missing".
std::string in_words(const StatusEntry& entry, const ClockText& clock);

/// status.txt: a line for the whole, one where the player is off, a line a remark, an empty one, then a line
/// a file.
std::string status_text(const StatusReport& report, const ClockText& clock);

}  // namespace vitrine::analyzer
