#include "player/control/metrics_file.hpp"

#include "base/system/atomic_file.hpp"
#include "base/system/log.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace vitrine::player {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

namespace {

constexpr auto interval = 15s;
constexpr const char* thermal_zones = "/sys/class/thermal";

}  // namespace

void MetricsFile::write_if_due(const std::string& file, std::chrono::nanoseconds now,
                               const std::function<std::string()>& text) {
    if (file.empty() || now < next_) return;
    next_ = now + interval;
    try {
        replace_file_unsynced(file, text());
        complaint_.clear();
    } catch (const std::system_error& error) {  // the wall works without metrics
        if (complaint_ != error.what()) log::warning("metrics: {}", error.what());
        complaint_ = error.what();
    }
}

std::optional<double> temperature() {
    constexpr double millidegrees = 1000;
    std::optional<double> highest;
    std::error_code none;
    for (const fs::directory_entry& zone : fs::directory_iterator(thermal_zones, none)) {
        double degrees = 0;
        std::ifstream in(zone.path() / "temp");
        if (in >> degrees)
            highest = std::max(highest.value_or(degrees / millidegrees), degrees / millidegrees);
    }
    return highest;
}

}  // namespace vitrine::player
