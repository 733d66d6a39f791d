#pragma once

#include "base/settings/settings.hpp"
#include "player/playback/source_events.hpp"
#include "player/render/renderer.hpp"
#include "player/scene/crossfade.hpp"
#include "player/scene/show.hpp"
#include "player/stage/stage_files.hpp"
#include "player/stage/tapestry_playback.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::player {

/// The answer to a wish for a tapestry.
enum class Opening {
    opened,
    later,  // a change of the wall or another switch was too short a time ago
    never,  // there is none and none will be woven
};

/// The wall of a stage, and a film's tapestry that replaces it for a while. Fades from one to the other. The
/// wall's time stands still while the tapestry is shown; a wall of several boxes goes on behind it.
class ShowSwitch {
  public:
    /// @param settings      outlive this
    /// @param owner         the owner of both shows' sources
    /// @param awaits_tiles  each frame of a tapestry waits for all its tiles
    ShowSwitch(const Settings& settings, std::uint64_t owner, bool awaits_tiles);

    Show& wall() { return *wall_; }

    const Show& wall() const { return *wall_; }

    /// The tapestry that is shown in place of the wall; none: the wall is shown.
    TapestryPlayback* tapestry() { return tapestry_.get(); }

    /// The size of the canvas, px. Before the first screen is known it is the most usual size.
    const Canvas& canvas() const { return canvas_; }

    void set_canvas(const Canvas& canvas);

    /// Updates the files of the wall. A tapestry whose film has changed is over.
    void set_files(const StageFiles& files);

    void handle_source_event(const SourceEvent& event);

    /// @param now  since the player's start, without the time in which no screen showed the stage
    void set_time(std::chrono::nanoseconds now) { time_ = now - away_; }

    /// The next frame of the wall or the tapestry, at the time that was set.
    /// @param renderer  gets the tiles of a tapestry; nullptr: there is none
    WallStep step(Renderer* renderer);

    /// Fades in the show that has just replaced the other.
    /// @param frame  the frame of the last step()
    void fade(Frame& frame);

    /// Shows a film's tapestry in place of the wall. If there is none of the present content of the film, the
    /// film plays above an empty strip until the analyzer has woven a first view.
    /// @param shot  the shot of the film at which the view starts
    /// @param at    the place that was touched, canvas px
    Opening open_tapestry(const RecordList::Record& film, std::size_t shot, Vec2 at);

    /// Shows the tapestry that the leader of a wall of several boxes shows, or the wall if it shows none.
    /// Call before each step().
    /// @param seen  nullptr: none
    /// @param film  nullptr: this box has no record of it
    void follow_tapestry(const TapestryMoment* seen, const RecordList::Record& film);

    /// Shows a tapestry in place of the wall.
    /// @param options  the stage sets the numbers of the sources and the waiting
    /// @throws std::runtime_error, std::system_error  naming the index that cannot be read
    void show_tapestry(const std::filesystem::path& directory, TapestryPlaybackOptions options);

    /// If the tapestry is over, the wall continues from where it was, unless the switch to the tapestry was
    /// too short a time ago.
    /// @return the sources of a tapestry that has faded out since
    std::vector<SourceId> leave_finished_tapestry();

    /// Call after the renderer was replaced: all pictures must be uploaded again.
    void forget_uploads();

  private:
    bool may_switch() const;
    bool is_fading() const;
    void note_switch();
    void complain(const SourceEvent& event);

    const Settings& settings_;  // outlive this
    std::uint64_t owner_;
    bool awaits_tiles_;
    Canvas canvas_{1920, 1080};
    std::unique_ptr<Show> wall_;
    std::unique_ptr<TapestryPlayback> tapestry_;  // none: the wall is shown
    std::unique_ptr<TapestryPlayback> leaving_;   // the last tapestry, while it fades out
    LeavingFrame shown_;                          // the last frame of the show that is on
    LeavingFrame left_;                           // the last frame of the show that fades out
    bool has_switched_ = false;                   // false: the first wall has not been replaced yet
    std::chrono::nanoseconds switched_{0};        // time of the last switch
    std::chrono::nanoseconds away_{0};            // total time in which tapestries were shown
    std::chrono::nanoseconds time_{0};            // the time that was set: the wall's or the tapestry's
    std::map<std::pair<SourceId, std::string>, std::chrono::nanoseconds> complaints_;  // when last logged
};

}  // namespace vitrine::player
