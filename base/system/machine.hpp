#pragma once

#include <chrono>
#include <string>

namespace vitrine {

/// The machine's name. Empty: it has none.
std::string host_name();

/// True if a service keeps the machine's clock right, as chrony and systemd-timesyncd do: the kernel knows
/// (adjtimex). False also where it may not be asked.
bool is_clock_kept_right();

/// The civil time in the time zone of the machine (TZ or /etc/localtime), even after the zone has changed.
/// When daylight saving ends, an hour comes twice; when it starts, an hour is skipped.
std::chrono::local_seconds local_time(std::chrono::system_clock::time_point time);

}  // namespace vitrine
