#pragma once

namespace vitrine {

/// True if a service keeps the machine's clock right, as chrony and systemd-timesyncd do: the kernel knows
/// (adjtimex). False also where it may not be asked.
bool is_clock_kept_right();

}  // namespace vitrine
