#pragma once

#include <chrono>

namespace vitrine {

/// The civil time in the time zone of the machine (TZ or /etc/localtime), even after the zone has changed.
/// When daylight saving ends, an hour comes twice; when it starts, an hour is skipped.
std::chrono::local_seconds local_time(std::chrono::system_clock::time_point time);

}  // namespace vitrine
