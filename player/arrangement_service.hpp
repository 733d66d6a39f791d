#pragma once

#include "player/content/arrangement_files.hpp"
#include "player/control/commands.hpp"

#include <chrono>
#include <filesystem>
#include <functional>
#include <future>
#include <optional>
#include <string>

namespace vitrine::player {

/// Keeps the arrangement of the walls over a restart of the player (`input.keep_arrangement`), and those with
/// a name (`vitrinectl layout`). A thread of its own writes, as a disk may take long. Logs.
class ArrangementService {
  public:
    struct Calls {
        std::function<WallArrangement()> present;          // walls that cannot be told now may be missing
        std::function<void(const WallArrangement&)> take;  // all becomes so; files that are gone are left out
    };

    ArrangementService(const std::filesystem::path& state, Calls calls);

    /// Takes the arrangement of the last run.
    void take_last();

    /// Call at every tick. @param is_kept  a restart shall find the arrangement
    void look(std::chrono::nanoseconds now, bool is_kept);

    /// Call when the run ends in order.
    void end_run(bool is_kept);

    /// Returns the handlers of `vitrinectl layout`. @pre this outlives them
    CommandHandlers handlers();

  private:
    WallArrangement present();
    CommandAnswer save(const std::string& name);
    CommandAnswer load(const std::string& name);

    ArrangementFiles files_;
    Calls calls_;
    std::optional<WallArrangement> last_;     // at the last look
    std::optional<WallArrangement> written_;  // the content of the file
    std::chrono::nanoseconds next_look_{0};
    bool has_complained_ = false;
    std::future<std::string> writing_;  // why that failed; last: its thread ends before the rest
};

}  // namespace vitrine::player
