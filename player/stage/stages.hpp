#pragma once

#include "player/scene/change_pace.hpp"
#include "player/scene/files/show_files.hpp"
#include "player/scene/show_controls.hpp"
#include "player/stage/output_canvas.hpp"
#include "player/stage/stage.hpp"

#include <chrono>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vitrine::player {

/// Walls by the folder of their stage; "": that of all outputs without a folder of their own.
using ArrangedWalls = std::map<std::string, ArrangedWall>;

/// The stages of a player, one for each folder that has an output of its own and one for all other outputs.
/// Logs.
class Stages {
  public:
    /// @param settings, sources  outlive this
    /// @param awaits_sources     the clock stands still until the sources of a frame are ready
    /// @param others            outputs of other boxes on the canvas of the first stage, as they are now
    Stages(const Settings& settings, SourcePool& sources, bool awaits_sources,
           std::shared_ptr<const OtherOutputs> others = {});

    /// Asks for new stages, because the settings have changed.
    void ask_anew() { is_asked_anew_ = true; }

    /// True once if new stages were asked for, and the walls were not made anew a moment ago: settings that
    /// are read again and again must not let the screens flash. Then call make_anew(). The screens keep their
    /// last picture until a new wall is complete, for eight seconds at most.
    bool claim_renewal(std::chrono::nanoseconds now);

    /// Replaces all stages with new ones without files.
    void make_anew();

    void set_catalogue(const RecordList& records, const ShowHints& hints);

    void set_controls(const ShowControls& controls);

    /// Arranges the walls anew. @param walls  by the folder of their stage; others stay as they are
    void arrange(const ArrangedWalls& walls);

    /// The walls as they stand now: those that are seen, and in which no folder is open.
    ArrangedWalls arrangement() const;

    /// Gives each screen to the stage of its output. @param screens  lent until the next call
    void set_screens(std::span<Screen* const> screens, std::chrono::nanoseconds now);

    /// @param event  its places are shares of the screen's sides
    void handle_input(const Screen& screen, InputEvent event);

    /// Draws one frame on every screen that is ready.
    /// @param renderer        nullptr: there is none, and no screen
    /// @param waits_for_wall  draws no frame in which the idle picture would be seen
    void show(std::chrono::nanoseconds now, Renderer* renderer, bool waits_for_wall);

    /// Draws guides for placing the screens above all for ten minutes, from the next frame on; or ends that.
    /// @return true: they are drawn
    bool toggle_guides();

    /// True: this box draws guides of its own accord.
    bool has_guides() const { return has_guides_; }

    /// Call after the renderer was replaced: all pictures must be uploaded again.
    void forget_uploads();

    /// The stage of all outputs without a folder of their own.
    Stage& first() { return *stages_.front(); }

    std::span<const std::unique_ptr<Stage>> all() const { return stages_; }

    /// The shots that may be heard.
    std::vector<AudibleShot> audible() const;

    /// All shown shots.
    std::vector<SlotShot> standing() const;

  private:
    Stage& stage_of(const Screen& screen);
    void log_counts();

    const Settings& settings_;  // outlives this
    SourcePool& sources_;       // outlives this
    bool awaits_sources_;
    std::shared_ptr<const OtherOutputs> others_;
    ShowControls controls_;
    std::map<std::string, std::shared_ptr<const ArrangedWall>>
        arranged_;                                  // by folder, until new stages are made
    std::map<std::string, std::size_t> number_of_;  // output -> stages_; other outputs show the first
    std::vector<std::unique_ptr<Stage>> stages_;
    ChangePace pace_{flash_spacing};
    std::chrono::nanoseconds picture_kept_until_{0};
    bool is_asked_anew_ = false;
    bool has_guides_ = false;
    std::optional<std::chrono::nanoseconds> guides_end_;  // none: the first frame with guides is to come
    std::map<std::string, std::size_t> logged_;  // folder -> the last logged number of shots on its wall
};

/// The first of the stages that a screen shows: that of outputs without a folder of their own, then the
/// others in the order of their outputs' names. Without a screen: the first of all.
Stage& first_seen(Stages& stages);

}  // namespace vitrine::player
