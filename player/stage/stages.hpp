#pragma once

#include "player/scene/show_controls.hpp"
#include "player/scene/show_files.hpp"
#include "player/stage/stage.hpp"

#include <chrono>
#include <cstddef>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace vitrine::player {

struct SlotShot;

/// The stages of a player, one for each folder that has an output of its own and one for all other outputs.
/// Logs.
class Stages {
  public:
    /// @param settings, sources  outlive this
    /// @param awaits_sources     the clock stands still until the sources of a picture are there
    Stages(const Settings& settings, SourcePool& sources, bool awaits_sources);

    /// Makes the stages anew, without files: the settings have changed.
    void make_anew();

    void set_catalogue(const RecordList& records, const ShowHints& hints);

    void set_controls(const ShowControls& controls);

    /// Gives each screen to the stage of its output. @param screens  lent until the next call
    void set_screens(std::span<Screen* const> screens, std::chrono::nanoseconds now);

    /// @param event  its places are shares of the screen
    void handle_input(const Screen& screen, InputEvent event);

    /// Draws one picture on every screen that can take one.
    /// @param waits_for_wall  no screen is given a picture through which the idle picture is seen
    void show(std::chrono::nanoseconds now, Renderer& renderer, bool waits_for_wall);

    /// Another renderer is used from now on: it has none of the pictures.
    void forget_uploads();

    /// The stage of all outputs without a folder of their own.
    Stage& first() { return *stages_.front(); }

    std::span<const std::unique_ptr<Stage>> all() const { return stages_; }

    /// The shots that may be heard.
    std::vector<AudibleShot> audible() const;

    /// The number of shots that are shown.
    std::size_t count() const;

    /// All shots that are shown.
    std::vector<SlotShot> standing() const;

  private:
    Stage& stage_of(const Screen& screen);
    void log_counts();

    const Settings& settings_;  // outlives this
    SourcePool& sources_;       // outlives this
    bool awaits_sources_;
    ShowControls controls_;
    std::map<std::string, std::size_t> number_of_;  // output -> stages_; the other outputs show the first
    std::vector<std::unique_ptr<Stage>> stages_;
    std::map<std::string, std::size_t> logged_;  // folder -> shots on its wall in the last log line
};

}  // namespace vitrine::player
