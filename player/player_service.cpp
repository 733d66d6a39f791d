#include "player/player_service.hpp"

#include "base/state/record_json.hpp"
#include "base/system/atomic_file.hpp"
#include "base/system/log.hpp"
#include "base/system/service.hpp"
#include "player/control/media_name.hpp"
#include "player/control/metrics_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <utility>

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;

constexpr auto metrics_interval = 15s;
constexpr std::size_t most_status_bytes = 64U << 20;  // of the analyzer's
constexpr const char* thermal_zones = "/sys/class/thermal";

const char* tier_of(const SourceState& source) {
    if (!source.is_film) return "photo";
    switch (source.detail) {
    case Detail::all:
        return "all";
    case Detail::references:
        return "reference";
    case Detail::keys:
        return "key";
    case Detail::still:
        break;
    }
    return "still";
}

template <typename T> void put(std::set<T>& set, const T& value, bool is_in) {
    if (is_in)
        set.insert(value);
    else
        set.erase(value);
}

}  // namespace

Operation::Operation(EventLoop& loop, OperatedParts parts) : loop_(loop), parts_(std::move(parts)) {}

void Operation::export_to_bus() {
    bus_.emplace(loop_, controls(), polkit_authority());
}

void Operation::tell_wishes() const {
    for (const auto& stage : parts_.stages)
        stage->set_controls(controls_);
}

void Operation::look(std::chrono::nanoseconds now) {
    now_ = now;
    std::vector<Sight::Screen> screens;
    std::size_t items = 0;
    if (parts_.display)
        for (const Screen* screen : parts_.display->screens())
            screens.push_back({.name = screen->name(), .flips = screen->flips()});
    for (const auto& stage : parts_.stages)
        items += stage->count();
    health_.see({.screens = screens, .is_away = parts_.display && parts_.display->is_away(), .items = items},
                now);
    if (health_.is_alive(now)) service::feed_watchdog();
}

void Operation::tell(std::chrono::nanoseconds now) {
    const std::uint64_t flips =
        parts_.display && !parts_.display->screens().empty() ? parts_.display->screens().front()->flips() : 0;
    const double seconds = std::chrono::duration<double>(now - std::exchange(told_, now)).count();
    const std::uint64_t before = std::exchange(flips_, flips);
    rate_ = seconds > 0 && flips >= before ? static_cast<double>(flips - before) / seconds : 0;
    service::status(one_line(report()));
    if (now < next_metrics_) return;
    next_metrics_ = now + metrics_interval;
    write_metrics_file();
}

void Operation::write_metrics_file() {
    const std::string& file = parts_.settings.metrics.file;
    if (file.empty()) return;
    std::vector<std::pair<std::string, std::size_t>> states;
    for (const auto& [state, count] : parts_.follower.counts())
        states.emplace_back(name_of(state), count);
    try {
        write_metrics(file, to_metrics(report(), hottest(thermal_zones), states));
        complaint_.clear();
    } catch (const std::system_error& error) {  // the wall needs no metrics
        if (complaint_ != error.what()) log::warning("metrics: {}", error.what());
        complaint_ = error.what();
    }
}

PlayerReport Operation::report() const {
    PlayerReport report{.state = health_.state(),
                        .display = parts_.display             ? parts_.display->description()
                                   : parts_.complaint.empty() ? "no graphics card for now"
                                                              : parts_.complaint,
                        .files = parts_.follower.records().size(),
                        .queue = parts_.sources.queue(),
                        .pictures = parts_.clock.pictures(),
                        .late = parts_.clock.late(),
                        .film_late = parts_.sources.late(),
                        .rate = rate_,
                        .since_flip =
                            std::chrono::duration_cast<std::chrono::milliseconds>(health_.since_flip(now_)),
                        .is_paused = controls_.is_paused,
                        .pinned = {controls_.files.begin(), controls_.files.end()},
                        .dismissed = dismissals_.paths()};
    if (parts_.display)
        for (const Screen* screen : parts_.display->screens())
            report.screens.push_back({.name = screen->name(),
                                      .width = screen->width(),
                                      .height = screen->height(),
                                      .refresh = screen->refresh(),
                                      .flips = screen->flips()});
    for (const auto& stage : parts_.stages)
        for (const SlotShot& shot : stage->standing())
            report.cells.push_back({.slot = shot.slot,
                                    .path = shot.key.path,
                                    .shot = shot.key.shot,
                                    .is_pinned = controls_.slots.contains(shot.slot) ||
                                                 controls_.files.contains(shot.key.path)});
    for (const SourceState& source : parts_.sources.states())
        report.sources.push_back({.path = source.path,
                                  .tier = tier_of(source),
                                  .is_stored = source.is_stored,
                                  .late = source.late});
    return report;
}

std::string Operation::analyzer_status() const {
    try {
        return read_file(std::filesystem::path(parts_.settings.state.directory) / "status.json",
                         most_status_bytes);
    } catch (const std::system_error&) {
        return {};  // an analyzer that leaves no word, or none
    }
}

FileReport Operation::described(const MediaRecord& record) const {
    FileReport report{.path = record.path,
                      .state = std::string(name_of(record.state)),
                      .reason = record.reason,
                      .kind = std::string(name_of(record.kind)),
                      .width = record.width,
                      .height = record.height,
                      .shots = record.shots.size(),
                      .is_pinned = controls_.files.contains(record.path),
                      .is_dismissed = dismissals_.contains(record.path)};
    for (const auto& stage : parts_.stages)
        for (const SlotShot& shot : stage->standing())
            if (shot.key.path == record.path) report.slots.push_back(shot.slot);
    return report;
}

FileReport Operation::file_report(const std::string& given, const std::string& folder) const {
    const std::string root = std::filesystem::absolute(parts_.settings.media.root).string();
    const std::vector<std::string> names = media_names(given, folder, root);
    const Catalogue catalogue(std::filesystem::path(parts_.settings.state.directory) / "catalogue");
    for (const std::string& name : names)
        if (const std::optional<MediaRecord> record = catalogue.find(name)) return described(*record);
    for (const std::string& name : names)
        if (::access(fmt::format("{}/{}", root, name).c_str(), F_OK) == 0)
            return {.path = name, .state = "new"};
    return {.path = given, .state = "unknown"};
}

/// The one of a file that can be shown.
MediaRecord Operation::shown_record(const std::string& given, const std::string& folder) const {
    const FileReport file = file_report(given, folder);
    const auto& records = parts_.follower.records();
    const auto found = std::ranges::find(records, file.path, &MediaRecord::path);
    if (found != records.end()) return *found;
    if (file.state == "unknown")
        throw std::runtime_error(fmt::format("there is no '{}' in the media folder", given));
    throw std::runtime_error(
        fmt::format("'{}' is not shown: {}", file.path, file.reason.empty() ? file.state : file.reason));
}

std::vector<Controls::Shot> Operation::screenshots() const {
    std::vector<Controls::Shot> shots;
    if (!parts_.display) return shots;
    for (Screen* screen : parts_.display->screens())
        if (std::optional<Picture> picture = screen->shown())
            shots.push_back({.output = screen->name(), .picture = std::move(*picture)});
    return shots;
}

void Operation::require_turns() const {
    if (parts_.settings.layout.mode == WallMode::pan)
        throw std::runtime_error("a wall that passes by (layout.mode = \"pan\") has no turns and no slots");
}

void Operation::pin(const std::string& path, bool is_on) {
    put(controls_.files, path, is_on);
    tell_wishes();
    log::info("{}: '{}'", is_on ? "pinned" : "not pinned any more", path);
}

Controls Operation::controls() {
    Controls controls;
    controls.status = [this] { return to_json(report(), analyzer_status()); };
    controls.why = [this](const std::string& file, const std::string& folder) {
        return to_json(file_report(file, folder), analyzer_status());
    };
    controls.screenshot = [this] { return screenshots(); };
    controls.reload = [this] { parts_.reload(); };
    controls.next = [this] {
        require_turns();
        ++controls_.turns;
        tell_wishes();
    };
    controls.pause = [this](bool is_on) {
        if (controls_.is_paused != is_on)
            log::info("the wall is {}", is_on ? "paused" : "not paused any more");
        controls_.is_paused = is_on;
        tell_wishes();
    };
    controls.pin_slot = [this](int slot, bool is_on) {
        require_turns();
        if (slot >= parts_.settings.layout.slots)
            throw std::runtime_error(fmt::format("there is no slot {}", slot));
        put(controls_.slots, slot, is_on);
        tell_wishes();
    };
    controls.pin = [this](const std::string& file, const std::string& folder, bool is_on) {
        require_turns();
        std::string path = is_on ? shown_record(file, folder).path : file_report(file, folder).path;
        pin(path, is_on);
        return path;
    };
    controls.remove = [this](const std::string& file, const std::string& folder) {
        const MediaRecord record = shown_record(file, folder);
        put(controls_.files, record.path, false);
        tell_wishes();
        dismissals_.add(record);
        log::info("removed from the wall: '{}'", record.path);
        parts_.give_catalogue();
        return record.path;
    };
    return controls;
}

}  // namespace vitrine::player
