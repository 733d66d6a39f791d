#include "base/state/media_origin.hpp"

#include "base/system/machine.hpp"

#include <algorithm>

namespace vitrine {

using namespace std::chrono_literals;

bool is_plausible(std::chrono::sys_time<std::chrono::milliseconds> taken,
                  std::chrono::system_clock::time_point now) {
    constexpr std::chrono::sys_days first = std::chrono::year(1990) / 1 / 1;
    return taken >= first && taken <= now + std::chrono::days(1);
}

std::chrono::minutes zone_here(std::chrono::system_clock::time_point time) {
    const auto utc = std::chrono::floor<std::chrono::seconds>(time).time_since_epoch();
    return std::chrono::round<std::chrono::minutes>(local_time(time).time_since_epoch() - utc);
}

TimeTaken taken_here(std::chrono::local_time<std::chrono::milliseconds> time) {
    using Moment = std::chrono::sys_time<std::chrono::milliseconds>;
    const Moment as_utc(time.time_since_epoch());
    const std::chrono::minutes near = zone_here(as_utc);
    const std::chrono::minutes zone = zone_here(as_utc - near);  // near a change of the zone they differ
    return {.at = as_utc - zone, .zone = zone, .source = TimeSource::camera_clock};
}

bool is_content_id(std::string_view text) {
    constexpr std::size_t max_length = 64;
    const auto is_allowed = [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '-';
    };
    return !text.empty() && text.size() <= max_length && std::ranges::all_of(text, is_allowed);
}

}  // namespace vitrine
