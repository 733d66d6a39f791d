#include "player/player_service.hpp"

#include "base/settings/settings.hpp"
#include "base/state/path_text.hpp"
#include "base/state/record_json.hpp"
#include "base/system/log.hpp"
#include "base/system/service.hpp"
#include "player/content/visible_files.hpp"
#include "player/control/media_name.hpp"
#include "player/display/screen.hpp"
#include "player/display_session.hpp"
#include "player/frame_clock.hpp"
#include "player/playback/source_pool.hpp"
#include "player/scene/show.hpp"
#include "player/stage/show_modes.hpp"
#include "player/stage/stages.hpp"
#include "player/wall_link/wall_link.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <utility>

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;

constexpr auto report_interval = 5s;

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

std::runtime_error unknown_file(const std::string& name) {
    return std::runtime_error(
        fmt::format("nothing is known of '{}': it is not in the media folder, or not analysed yet", name));
}

/// Refuses what only the leader of several boxes can do: here it would change nothing.
void leave_to_leader(CommandHandlers& handlers) {
    const auto refuse = [](const CommandCall&) -> CommandAnswer {
        throw std::runtime_error("this box follows: the box that leads decides that; call vitrinectl there");
    };
    for (const Command& command : commands())
        if (command.is_for_leader) handlers.insert_or_assign(command.method, refuse);
}

template <typename T> void put(std::set<T>& set, const T& value, bool is_in) {
    if (is_in)
        set.insert(value);
    else
        set.erase(value);
}

}  // namespace

PlayerService::PlayerService(EventLoop& loop, const PlayerView& view, PlayerActions actions)
    : loop_(loop),
      view_(view),
      actions_(std::move(actions)),
      arrangement_(view.settings.state.directory,
                   {.present = [this] { return arrangement(); },
                    .take = [this](const WallArrangement& arrangement) { take(arrangement); }}),
      analyzer_(std::filesystem::path(view.settings.state.directory) / "status.json"),
      report_(loop.timer([this] { report_status(); })) {
    const Settings& settings = view.settings;
    if (settings.status.played && !settings.status.folder.empty() && !view.is_rehearsed)
        played_.emplace(settings.state.directory);
    report_.arm(0s);
}

void PlayerService::export_to_bus() {
    bus_.emplace(loop_, handlers(), polkit_authority());
}

void PlayerService::look(std::chrono::nanoseconds now) {
    now_ = now;
    analyzer_.look(now);
    arrangement_.look(now, view_.settings.input.keep_arrangement);
    if (played_) played_->look(view_.stages, view_.sources, now);
    std::vector<ScreenState::Screen> screens;
    for (const Screen* screen : view_.display.screens())
        screens.push_back({.name = screen->name(), .flips = screen->flips()});
    health_.set_screens(
        {.screens = screens, .is_away = view_.display.is_away(), .items = view_.stages.standing().size()},
        now);
    if (health_.feed_watchdog_now(now)) service::feed_watchdog();
}

/// All that visitors and staff have arranged, as it is now.
WallArrangement PlayerService::arrangement() const {
    WallArrangement arrangement{.walls = view_.stages.arrangement(),
                                .pinned = controls_.files,
                                .slots = controls_.slots,
                                .removed = {}};
    for (const std::string& path : view_.files.dismissed())
        if (const RecordList::Record file = view_.files.catalogue().find(path))
            arrangement.removed.push_back({.path = path, .bytes = file->bytes, .mtime_ns = file->mtime_ns});
    return arrangement;
}

/// Lets all be as it was. What is gone or has changed is left out.
void PlayerService::take(const WallArrangement& arrangement) {
    std::set<std::string> removed;
    for (const RemovedFile& known : arrangement.removed) {
        const RecordList::Record file = view_.files.catalogue().find(known.path);
        if (file && file->bytes == known.bytes && file->mtime_ns == known.mtime_ns)
            removed.insert(known.path);
    }
    controls_.files.clear();
    for (const std::string& path : arrangement.pinned)
        if (view_.files.catalogue().find(path)) controls_.files.insert(path);
    controls_.slots.clear();
    for (const int slot : arrangement.slots)
        if (slot >= 0 && slot < view_.settings.layout.slots) controls_.slots.insert(slot);
    actions_.set_dismissed(removed);
    actions_.set_controls(controls_);
    actions_.arrange(arrangement.walls);
}

/// Reports to systemd and to the node exporter which pictures are shown, and at which rate.
void PlayerService::report_status() {
    report_.arm(report_interval);
    const std::span<Screen* const> screens = view_.display.screens();
    rate_.report(screens.empty() ? 0 : screens.front()->flips(), now_);
    faults_.look(view_.settings, screens, *view_.wall.others(), view_.files.catalogue());
    service::status(one_line(report()));
    metrics_.write_if_due(view_.settings.metrics.file, now_, [this] {
        std::vector<std::pair<std::string, std::size_t>> states;
        for (const auto& [state, count] : view_.files.counts())
            states.emplace_back(name_of(state), count);
        return to_metrics(report(), temperature(), states);
    });
}

PlayerReport PlayerService::report() const {
    PlayerReport report{.state = health_.state(),
                        .display = view_.display.description(),
                        .faults = faults_.all(),
                        .files = view_.files.count_ready(),
                        .queue = view_.sources.queue(),
                        .pictures = view_.clock.pictures(),
                        .late = view_.clock.late(),
                        .film_late = view_.sources.late(),
                        .rate = rate_.rate(),
                        .since_flip =
                            std::chrono::duration_cast<std::chrono::milliseconds>(health_.since_flip(now_)),
                        .is_paused = controls_.is_paused,
                        .pinned = {controls_.files.begin(), controls_.files.end()},
                        .dismissed = view_.files.dismissed()};
    for (const Screen* screen : view_.display.screens())
        report.screens.push_back({.name = screen->name(),
                                  .width = screen->width(),
                                  .height = screen->height(),
                                  .refresh = screen->refresh(),
                                  .flips = screen->flips()});
    for (const SlotShot& shot : view_.stages.standing())
        report.cells.push_back(
            {.slot = shot.slot,
             .path = shot.key.path,
             .shot = shot.key.shot,
             .is_pinned = controls_.slots.contains(shot.slot) || controls_.files.contains(shot.key.path)});
    for (const SourceState& source : view_.sources.states())
        report.sources.push_back({.path = source.path,
                                  .tier = tier_of(source),
                                  .is_stored = source.is_stored,
                                  .late = source.late});
    return report;
}

FileReport PlayerService::describe(const MediaRecord& record) const {
    const std::vector<std::string> dismissed = view_.files.dismissed();
    FileReport report{.path = record.path,
                      .state = std::string(name_of(record.state)),
                      .reason = record.reason,
                      .kind = std::string(name_of(record.kind)),
                      .width = record.width,
                      .height = record.height,
                      .shots = record.shots.size(),
                      .visibility = view_.files.judge(record),
                      .is_pinned = controls_.files.contains(record.path),
                      .is_dismissed = std::ranges::find(dismissed, record.path) != dismissed.end()};
    for (const SlotShot& shot : view_.stages.standing())
        if (shot.key.path == record.path) report.slots.push_back(shot.slot);
    return report;
}

/// Never looks into the media folder: a share that hangs would keep the wall waiting.
FileReport PlayerService::report_file(const std::string& given, const std::string& folder) const {
    const std::string root = std::filesystem::absolute(view_.settings.media.root).string();
    const std::vector<std::string> names = media_names(given, folder, root);
    for (const std::string& name : names)
        if (const auto record = view_.files.catalogue().find(name)) return describe(*record);
    FileReport unknown{.path = given, .state = "unknown"};
    if (std::ranges::any_of(names, is_in_inbox))
        unknown.reason = "It is in the inbox: it is shown once somebody has moved it out.";
    for (const std::string& name : names)
        unknown.places.push_back(fmt::format("{}/{}", root, name));
    return unknown;
}

/// The record of a file that is shown. Lent until the event loop runs again.
const MediaRecord& PlayerService::require_shown(const std::string& given, const std::string& folder) const {
    const FileReport file = report_file(given, folder);
    const RecordList::Record record = view_.files.catalogue().find(file.path);
    if (record && is_ready(*record)) return *record;
    if (file.state == "unknown") throw unknown_file(given);
    throw std::runtime_error(
        fmt::format("'{}' is not shown: {}", file.path, file.reason.empty() ? file.state : file.reason));
}

/// The pictures are only copied from the displays here; the rest is done in another thread.
CommandAnswer PlayerService::take_screenshots() {
    if (!screenshots_.take_turn(now_))
        throw std::runtime_error("a screenshot was taken this very second; try again in a second");
    std::vector<std::pair<std::string, CardPicture>> shots;
    for (Screen* screen : view_.display.screens())
        if (std::optional<CardPicture> picture = screen->shown())
            shots.emplace_back(screen->name(), std::move(*picture));
    return {.make_pictures = [shots = std::move(shots)] {
        std::vector<OutputPicture> pictures;
        for (const auto& [output, picture] : shots)
            pictures.push_back({.output = output, .picture = to_picture(picture)});
        return pictures;
    }};
}

void PlayerService::require_turns() const {
    if (!show_mode(view_.settings).has_turns)
        throw std::runtime_error("this kind of wall (layout.mode) has no turns and no slots");
}

CommandAnswer PlayerService::next() {
    require_turns();
    ++controls_.turns;
    actions_.set_controls(controls_);
    return {};
}

CommandAnswer PlayerService::pause(const CommandCall& call) {
    if (controls_.is_paused != call.is_on)
        log::info("the wall is {}", call.is_on ? "paused" : "not paused any more");
    controls_.is_paused = call.is_on;
    actions_.set_controls(controls_);
    return {};
}

CommandAnswer PlayerService::pin_slot(const CommandCall& call) {
    require_turns();
    if (call.slot < 0 || call.slot >= view_.settings.layout.slots)
        throw std::runtime_error(fmt::format("there is no slot {}", call.slot));
    put(controls_.slots, call.slot, call.is_on);
    actions_.set_controls(controls_);
    return {};
}

CommandAnswer PlayerService::pin(const CommandCall& call) {
    require_turns();
    const std::string path =
        call.is_on ? require_shown(call.file, call.folder).path : report_file(call.file, call.folder).path;
    put(controls_.files, path, call.is_on);
    actions_.set_controls(controls_);
    log::info("{}: '{}'", call.is_on ? "pinned" : "not pinned any more", path);
    return {.text = path, .pictures = {}};
}

CommandAnswer PlayerService::remove(const CommandCall& call) {
    const MediaRecord record = require_shown(call.file, call.folder);
    put(controls_.files, record.path, false);
    actions_.set_controls(controls_);
    log::info("removed from the wall: '{}'", record.path);
    const std::vector<std::string> before = view_.files.dismissed();
    std::set<std::string> dismissed(before.begin(), before.end());
    dismissed.insert(record.path);
    actions_.set_dismissed(dismissed);
    return {.text = record.path, .pictures = {}};
}

CommandAnswer PlayerService::acquit(const CommandCall& call) {
    if (call.file.empty()) {
        actions_.acquit("");
        log::info("all files are acquitted");
        return {.text = "all files", .pictures = {}};
    }
    const FileReport file = report_file(call.file, call.folder);
    if (file.state == "unknown") throw unknown_file(call.file);
    actions_.acquit(file.path);
    log::info("acquitted: '{}'", file.path);
    return {.text = file.path, .pictures = {}};
}

/// One handler for each method of commands().
CommandHandlers PlayerService::handlers() {
    using Call = CommandCall;
    const auto text = [](std::string said) { return CommandAnswer{.text = std::move(said), .pictures = {}}; };
    const auto why = [this, text](const Call& call) {
        const FileReport file = report_file(call.file, call.folder);
        return text(to_json(file, analyzer_.word().entry(file.path)));
    };
    const auto reload = [this](const Call&) {
        actions_.reload();
        return CommandAnswer{};
    };
    const auto canvas = [this, text](const Call&) {
        return text(actions_.toggle_guides() ? "guides are drawn for ten minutes; the same command ends that"
                                             : "no guides are drawn any more");
    };
    CommandHandlers handlers{{"Status",
                              [this, text](const Call&) {
                                  return text(
                                      to_json(report(), analyzer_.word().summary, view_.wall.report()));
                              }},
                             {"Why", why},
                             {"Screenshot", [this](const Call&) { return take_screenshots(); }},
                             {"Next", [this](const Call&) { return next(); }},
                             {"Pause", [this](const Call& call) { return pause(call); }},
                             {"Pin", [this](const Call& call) { return pin(call); }},
                             {"PinSlot", [this](const Call& call) { return pin_slot(call); }},
                             {"Remove", [this](const Call& call) { return remove(call); }},
                             {"Acquit", [this](const Call& call) { return acquit(call); }},
                             {"Canvas", canvas},
                             {"Reload", reload}};
    handlers.merge(arrangement_.handlers());
    if (view_.settings.wall.role == WallRole::follow) leave_to_leader(handlers);
    return handlers;
}

}  // namespace vitrine::player
