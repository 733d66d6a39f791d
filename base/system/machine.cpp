#include "base/system/machine.hpp"

#include <sys/timex.h>
#include <unistd.h>

#include <array>
#include <ctime>

namespace vitrine {

std::string host_name() {
    std::array<char, 256> name{};  // longer than Linux has them
    return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

bool is_clock_kept_right() {
    timex question{};  // it changes nothing
    const int state = ::adjtimex(&question);
    return state >= 0 && state != TIME_ERROR && (question.status & STA_UNSYNC) == 0;
}

std::chrono::local_seconds local_time(std::chrono::system_clock::time_point time) {
    const auto utc = std::chrono::floor<std::chrono::seconds>(time);
    const std::time_t seconds = utc.time_since_epoch().count();
    std::tm civil{};
    ::tzset();  // localtime_r() alone does not notice a new zone
    if (::localtime_r(&seconds, &civil) == nullptr) return std::chrono::local_seconds(utc.time_since_epoch());
    return std::chrono::local_seconds(utc.time_since_epoch() + std::chrono::seconds(civil.tm_gmtoff));
}

}  // namespace vitrine
