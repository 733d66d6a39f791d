#include "player/content/calendar.hpp"

#include "base/system/machine.hpp"

#include <sys/stat.h>

#include <algorithm>

namespace vitrine::player {

namespace fs = std::filesystem;
using std::chrono::system_clock;

namespace {

constexpr system_clock::time_point built{std::chrono::seconds(VITRINE_BUILT)};  // set by CMake

system_clock::time_point changed_at(const fs::path& file) {
    struct stat status {};

    if (::stat(file.c_str(), &status) < 0) return {};
    return system_clock::time_point(std::chrono::seconds(status.st_mtim.tv_sec));
}

}  // namespace

void EarliestTime::record_written(system_clock::time_point time) {
    constexpr auto max_life = std::chrono::years(10);
    if (time < built_ + max_life) time_ = std::max(time_, time);
}

Calendar::Calendar(const fs::path& catalogue) : earliest_(built) {
    std::error_code missing;
    for (const fs::directory_entry& entry : fs::directory_iterator(catalogue, missing))
        earliest_.record_written(changed_at(entry.path()));
}

std::optional<std::chrono::local_seconds> Calendar::now() const {
    const system_clock::time_point now = system_clock::now();
    if (now < earliest_.time() && !is_clock_kept_right()) return std::nullopt;
    return local_time(now);
}

}  // namespace vitrine::player
