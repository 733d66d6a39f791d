#pragma once

#include "base/system/event_loop.hpp"
#include "player/arrangement_service.hpp"
#include "player/control/analyzer_word.hpp"
#include "player/control/bus_object.hpp"
#include "player/control/commands.hpp"
#include "player/control/flip_rate.hpp"
#include "player/control/health.hpp"
#include "player/control/metrics_file.hpp"
#include "player/control/player_report.hpp"
#include "player/control/rate_limit.hpp"
#include "player/played_files.hpp"
#include "player/scene/show_controls.hpp"
#include "player/stage/output_faults.hpp"
#include "player/stage/stages.hpp"

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <set>
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
class VisibleFiles;
class WallLink;

/// The parts of a player that the service reads. Each outlives the service.
struct PlayerView {
    const Settings& settings;
    const DisplaySession& display;
    const VisibleFiles& files;
    const Stages& stages;
    const SourcePool& sources;
    const FrameClock& clock;
    const WallLink& wall;
    bool is_rehearsed = false;  // what is shown is no play that counts
};

/// The changes that the service makes to a player.
struct PlayerActions {
    std::function<void(const ShowControls&)> set_controls;            // sets the controls of all walls
    std::function<void(const std::set<std::string>&)> set_dismissed;  // takes these files off the wall
    std::function<void(const ArrangedWalls&)> arrange;                // arranges the walls anew
    std::function<void(const std::string& path)> acquit;  // ends the quarantine of a file; "": of all
    std::function<void()> reload;         // reads the settings again; throws if they are wrong
    std::function<bool()> toggle_guides;  // for placing screens; true: they are drawn now
};

/// Serves everything that looks after a player: systemd, whose watchdog it feeds while pictures reach the
/// displays; vitrinectl, over the bus; a node exporter, through a file. It returns freed memory to the
/// system.
class PlayerService {
  public:
    /// @param loop  outlives this
    PlayerService(EventLoop& loop, const PlayerView& view, PlayerActions actions);

    /// Exports the player on the system bus, if there is one.
    void export_to_bus();

    /// Call at every tick. @param now  since the player's start
    void look(std::chrono::nanoseconds now);

    /// Keeps what has been arranged over a restart.
    ArrangementService& arrangements() { return arrangement_; }

  private:
    void report_status();
    CommandHandlers handlers();
    PlayerReport report() const;
    FileReport report_file(const std::string& given, const std::string& folder) const;
    FileReport describe(const MediaRecord& record) const;
    const MediaRecord& require_shown(const std::string& given, const std::string& folder) const;
    CommandAnswer take_screenshots();
    void require_turns() const;
    CommandAnswer next();
    CommandAnswer pause(const CommandCall& call);
    CommandAnswer pin_slot(const CommandCall& call);
    CommandAnswer pin(const CommandCall& call);
    CommandAnswer remove(const CommandCall& call);
    CommandAnswer acquit(const CommandCall& call);
    WallArrangement arrangement() const;
    void take(const WallArrangement& arrangement);

    EventLoop& loop_;  // outlives this
    PlayerView view_;
    PlayerActions actions_;
    Health health_;
    ShowControls controls_;
    ArrangementService arrangement_;
    MetricsFile metrics_;
    AnalyzerWordReader analyzer_;
    RateLimit screenshots_{std::chrono::seconds(1)};
    std::chrono::nanoseconds now_{0};  // the time of the last look()
    OutputFaults faults_;
    FlipRate rate_;                      // of the first screen, between the last two reports
    std::optional<PlayedFiles> played_;  // none: nobody wants to know
    EventLoop::Source report_;
    std::optional<BusObject> bus_;
};

}  // namespace vitrine::player
