#pragma once

#include <chrono>

namespace vitrine {

/// What the clocks on the wall show, in the time zone that the machine is set to by now: TZ or
/// /etc/localtime. Where daylight saving ends, an hour of it comes twice; where it begins, one never comes.
std::chrono::local_seconds local_time(std::chrono::system_clock::time_point time);

}  // namespace vitrine
