#include "base/system/local_time.hpp"

#include <ctime>

namespace vitrine {

std::chrono::local_seconds local_time(std::chrono::system_clock::time_point time) {
    const auto utc = std::chrono::floor<std::chrono::seconds>(time);
    const std::time_t seconds = utc.time_since_epoch().count();
    std::tm civil{};
    ::tzset();  // localtime_r() alone does not notice a new zone
    if (::localtime_r(&seconds, &civil) == nullptr) return std::chrono::local_seconds(utc.time_since_epoch());
    return std::chrono::local_seconds(utc.time_since_epoch() + std::chrono::seconds(civil.tm_gmtoff));
}

}  // namespace vitrine
