#include "analyzer/watch/daemon.hpp"

#include "analyzer/status/plain_text.hpp"
#include "analyzer/status/status_summary.hpp"
#include "base/state/record_json.hpp"
#include "base/system/journal.hpp"
#include "base/system/service.hpp"

#include <fmt/format.h>

#include <utility>

// What the daemon says of itself and of each file.

namespace vitrine::analyzer {

namespace fs = std::filesystem;

namespace {

std::string in_words(std::chrono::seconds time) {
    return time < std::chrono::minutes(2) ? fmt::format("{} s", time.count())
                                          : fmt::format("{} min", time.count() / 60);
}

}  // namespace

/// For `systemctl status`: where the files stand, what is looked at now, and what is wrong.
std::string Daemon::status() const {
    if (!is_online()) return remarks_.empty() ? "starting" : plain_text(remarks_.front());
    std::string text = summary(states_.counts(schedule_));
    const char* before = "; looking at ";
    for (const auto& [path, since] : reading_) {
        const auto time = std::chrono::floor<std::chrono::seconds>(EventLoop::Clock::now() - since);
        text += fmt::format("{}'{}' for {}", before, plain_text(path), in_words(time));
        before = ", ";
    }
    if (!unsaved_.empty())
        text += fmt::format("; {} record{} cannot be stored: is the disk full?", unsaved_.size(),
                            unsaved_.size() == 1 ? "" : "s");
    if (!remarks_.empty()) text += "; " + plain_text(remarks_.front());
    return text;
}

/// While a file is looked at the time that it takes is told as it passes.
void Daemon::tell_systemd() {
    constexpr auto reading_rest = std::chrono::seconds(15);
    is_telling_ = false;
    service::status(status());
    if (!reading_.empty()) telling_.arm(reading_rest);
}

/// Something has been done just now, in the midst of what may take longer than systemd waits.
void Daemon::get_on() {
    const auto interval = service::watchdog_interval();
    const Schedule::Time now = EventLoop::Clock::now();
    if (!interval || (fed_ && now < *fed_ + *interval / 4)) return;
    service::feed_watchdog();
    fed_ = now;
    watchdog_.arm(*interval / 2);  // what waits in the loop meanwhile comes first
}

/// Systemd hears that all is well while what is to happen does happen.
void Daemon::feed_watchdog() {
    const auto interval = service::watchdog_interval();
    if (!interval) return;
    watchdog_.arm(*interval / 2);
    const std::string missed = pulse_.missed(EventLoop::Clock::now()).value_or("");
    if (!missed.empty() && missed != missed_)
        log::error("it does not come about that {}: systemd is not told that all is well", missed);
    missed_ = missed;
    if (missed.empty()) get_on();
}

void Daemon::make_thumbnails() {
    std::vector<std::string> files;
    for (const std::string& path : status_.lacking())
        files.push_back(folder_.absolute(path).string());
    if (is_online()) thumbnails_.make(files);
}

void Daemon::tell(const MediaRecord& record) {
    ++analysed_;
    if (options_.is_once) {
        std::size_t unfinished = 0;
        schedule_.visit_files([&](const std::string&, Schedule::Progress progress, Schedule::Time) {
            using Progress = Schedule::Progress;
            unfinished += progress != Progress::done && progress != Progress::waiting ? 1 : 0;
        });
        log::info("analysed {} of {}: {}", analysed_, analysed_ + unfinished, record.path);
    }
    if (record.state != MediaState::ready)
        log::write_with(log::Level::warning,
                        fmt::format("{}: '{}': {}", name_of(record.state), record.path, record.reason),
                        journal_fields(record));
    else if (!record.reason.empty())
        log::warning("ready: '{}': {}", record.path, record.reason);
    else if (!options_.is_once)
        log::info("ready: '{}'", record.path);
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

}  // namespace vitrine::analyzer
