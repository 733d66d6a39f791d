#include "analyzer/daemon.hpp"

#include <fmt/format.h>

// What the daemon says of itself and of each file.

namespace vitrine {

namespace fs = std::filesystem;

std::string Daemon::status() const {
    if (!is_online()) return remarks_.empty() ? "starting" : remarks_.front();
    const Schedule::Counts counts = schedule_.counts();
    return fmt::format("{} files, {} of them being analysed, {} to come, {} waiting to be complete",
                       counts.files, counts.running, counts.due + counts.settling, counts.waiting);
}

std::vector<FileState> Daemon::files() const {
    return states_.list(schedule_, EventLoop::Clock::now(), std::chrono::system_clock::now());
}

fs::path Daemon::thumbnail(const std::string& path) const {
    return options_.state / "thumbnails" / (record_id(path) + ".jpg");
}

StatusReport Daemon::report() const {
    StatusReport report{.remarks = hint_files_.faults(), .is_online = is_online()};
    report.remarks.insert(report.remarks.end(), remarks_.begin(), remarks_.end());
    for (FileState& file : files()) {
        Hints hints = hints_of(file.path, hint_files_.hints());
        std::string id = record_id(file.path);
        report.files.push_back({.file = std::move(file), .hints = hints, .id = std::move(id)});
    }
    return report;
}

}  // namespace vitrine
