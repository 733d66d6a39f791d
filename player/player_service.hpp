#pragma once

#include "base/settings/settings.hpp"
#include "base/system/event_loop.hpp"
#include "player/content/catalogue_follower.hpp"
#include "player/content/dismissals.hpp"
#include "player/control/bus_object.hpp"
#include "player/control/health.hpp"
#include "player/control/player_report.hpp"
#include "player/display/display.hpp"
#include "player/frame_clock.hpp"
#include "player/playback/source_pool.hpp"
#include "player/scene/show_controls.hpp"
#include "player/stage/stage.hpp"

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::player {

/// The parts of a player that its operation is about. All outlive it.
struct OperatedParts {
    const Settings& settings;
    const std::unique_ptr<Display>& display;  // none: no graphics card for now
    const std::string& complaint;             // why
    const std::vector<std::unique_ptr<Stage>>& stages;
    const SourcePool& sources;
    const CatalogueFollower& follower;
    const FrameClock& clock;
    std::function<void()> give_catalogue;  // to the stages, once it is another
    std::function<void()> reload;          // the settings; throws what is wrong with them
};

/// What a player is to those who look after it: systemd, which is told that pictures reach the displays;
/// vitrinectl, over the bus; a node exporter, through a file.
class Operation {
  public:
    /// @param loop  outlives this
    Operation(EventLoop& loop, OperatedParts parts);

    /// Has people reach the player over the system bus, where there is one.
    void export_to_bus();

    /// Those of the records that nobody wants off the wall.
    std::vector<MediaRecord> wanted(const std::vector<MediaRecord>& records) {
        return dismissals_.filtered(records);
    }

    /// Stages that were made anew learn what is wanted of them.
    void tell_wishes() const;

    /// To be called at every tick. @param now  since the player's start
    void look(std::chrono::nanoseconds now);

    /// Tells systemd, and the node exporter, how it stands; to be called every few seconds.
    void tell(std::chrono::nanoseconds now);

  private:
    Controls controls();
    PlayerReport report() const;
    FileReport file_report(const std::string& given, const std::string& folder) const;
    FileReport described(const MediaRecord& record) const;
    MediaRecord shown_record(const std::string& given, const std::string& folder) const;
    std::string analyzer_status() const;
    std::vector<Controls::Shot> screenshots() const;
    void require_turns() const;
    void pin(const std::string& path, bool is_on);
    void write_metrics_file();

    EventLoop& loop_;  // outlives this
    OperatedParts parts_;
    Health health_;
    Dismissals dismissals_;
    ShowControls controls_;
    std::chrono::nanoseconds now_{0};  // as of the last look
    std::chrono::nanoseconds told_{0};
    std::uint64_t flips_ = 0;  // of the first screen when systemd was told
    double rate_ = 0;          // flips a second since
    std::chrono::nanoseconds next_metrics_{0};
    std::string complaint_;  // of the metrics file, as last told
    std::optional<BusObject> bus_;
};

}  // namespace vitrine::player
