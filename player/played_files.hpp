#pragma once

#include "player/content/calendar.hpp"
#include "player/control/play_ledger.hpp"
#include "player/stage/seen_files.hpp"

#include <chrono>
#include <filesystem>

namespace vitrine::player {

class SourcePool;
class Stages;

/// Proof of play: notes for how long each file is seen on a panel, day by day.
class PlayedFiles {
  public:
    /// @param state  the state directory
    explicit PlayedFiles(const std::filesystem::path& state)
        : calendar_(state / "catalogue"), ledger_(state / played_folder) {}

    /// Looks ten times a second. Call at every tick. @param now  since the player's start
    void look(const Stages& stages, const SourcePool& sources, std::chrono::nanoseconds now);

  private:
    static constexpr std::chrono::milliseconds interval{100};

    std::chrono::nanoseconds next_look_{0};
    Calendar calendar_;
    SeenFiles seen_;
    PlayLedger ledger_;
};

}  // namespace vitrine::player
