#pragma once

#include <ctime>

namespace vitrine::analyzer {

/// Processor time that the process, or the thread, has used so far.
inline double cpu_seconds(clockid_t clock = CLOCK_PROCESS_CPUTIME_ID) {
    timespec time{};
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace vitrine::analyzer
