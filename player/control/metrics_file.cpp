#include "player/control/metrics_file.hpp"

#include "base/system/error.hpp"

#include <algorithm>
#include <fstream>

namespace vitrine::player {

namespace fs = std::filesystem;

void write_metrics(const fs::path& file, const std::string& text) {
    fs::path written = file;
    written += ".new";  // a node exporter reads *.prom only
    std::ofstream out(written, std::ios::trunc);
    out << text;
    out.close();
    if (!out) throw_errno("write '{}'", written.string());
    fs::rename(written, file);
}

std::optional<double> hottest(const fs::path& zones) {
    constexpr double millidegrees = 1000;
    std::optional<double> most;
    std::error_code none;
    for (const fs::directory_entry& zone : fs::directory_iterator(zones, none)) {
        double degrees = 0;
        std::ifstream in(zone.path() / "temp");
        if (in >> degrees) most = std::max(most.value_or(degrees / millidegrees), degrees / millidegrees);
    }
    return most;
}

}  // namespace vitrine::player
