#pragma once

#include "base/system/event_loop.hpp"
#include "player/control/bus_object.hpp"
#include "player/control/commands.hpp"
#include "player/control/health.hpp"
#include "player/control/metrics_file.hpp"
#include "player/control/player_report.hpp"
#include "player/scene/show_controls.hpp"

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vitrine {

struct MediaRecord;
struct Settings;

}  // namespace vitrine

namespace vitrine::player {

class DisplaySession;
class FrameClock;
class SourcePool;
class Stages;
class VisibleFiles;

/// The parts of a player that the service reads. Each outlives it.
struct PlayerView {
    const Settings& settings;
    const DisplaySession& display;
    const VisibleFiles& files;
    const Stages& stages;
    const SourcePool& sources;
    const FrameClock& clock;
};

/// The changes of a player that the service asks for.
struct PlayerActions {
    std::function<void(const ShowControls&)> set_controls;  // sets the controls of all walls
    std::function<void(const MediaRecord&)> dismiss;        // takes a file off the wall
    std::function<void()> reload;                           // the settings; throws what is wrong with them
};

/// Serves those who look after a player: systemd, whose watchdog it feeds while pictures reach the displays;
/// vitrinectl, over the bus; a node exporter, through a file.
class PlayerService {
  public:
    /// @param loop  outlives this
    PlayerService(EventLoop& loop, const PlayerView& view, PlayerActions actions);

    /// People reach the player over the system bus from now on, where there is one.
    void export_to_bus();

    /// To be called at every tick. @param now  since the player's start
    void look(std::chrono::nanoseconds now);

  private:
    void report_status();
    CommandHandlers handlers();
    PlayerReport report() const;
    FileReport report_file(const std::string& given, const std::string& folder) const;
    FileReport describe(const MediaRecord& record) const;
    const MediaRecord& require_shown(const std::string& given, const std::string& folder) const;
    std::string analyzer_status() const;
    std::vector<OutputPicture> screenshots() const;
    void require_turns() const;
    CommandAnswer next();
    CommandAnswer pause(const CommandCall& call);
    CommandAnswer pin_slot(const CommandCall& call);
    CommandAnswer pin(const CommandCall& call);
    CommandAnswer remove(const CommandCall& call);

    EventLoop& loop_;  // outlives this
    PlayerView view_;
    PlayerActions actions_;
    Health health_;
    ShowControls controls_;
    MetricsFile metrics_;
    std::chrono::nanoseconds now_{0};       // the time of the last look()
    std::chrono::nanoseconds reported_{0};  // when systemd was told last
    std::uint64_t flips_ = 0;               // flips of the first screen at that time
    double rate_ = 0;                       // flips a second since the report before
    EventLoop::Source report_;
    std::optional<BusObject> bus_;
};

}  // namespace vitrine::player
