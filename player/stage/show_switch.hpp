#pragma once

#include "base/settings/settings.hpp"
#include "player/playback/source_events.hpp"
#include "player/render/renderer.hpp"
#include "player/scene/show.hpp"
#include "player/stage/stage_files.hpp"
#include "player/stage/tapestry_playback.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace vitrine::player {

/// The wall of a stage, and the tapestry of a film that takes its place for a while. One fades into the
/// other, and the wall's time stands still while the tapestry is shown.
class ShowSwitch {
  public:
    /// @param settings      outlive this
    /// @param owner         the owner of both shows' sources
    /// @param awaits_tiles  every frame of a tapestry is whole, however long its tiles take
    ShowSwitch(const Settings& settings, std::uint64_t owner, bool awaits_tiles);

    Show& wall() { return *wall_; }

    const Show& wall() const { return *wall_; }

    /// The tapestry that is shown in place of the wall; none: the wall is shown.
    TapestryPlayback* tapestry() { return tapestry_.get(); }

    /// The size of the canvas, px; until the first screen is known, that of the most usual screen.
    Vec2 canvas() const { return canvas_; }

    void set_canvas(Vec2 canvas);

    /// The wall shows the files that pass the stage's filters; a tapestry whose film has changed is over.
    void set_files(const StageFiles& files);

    void handle_source_event(const SourceEvent& event);

    /// @param now  since the player's start, without the time that no screen showed the stage
    void set_time(std::chrono::nanoseconds now) { time_ = now - away_; }

    /// The wall or the tapestry at the time that was set.
    /// @param renderer  is given the tiles of a tapestry
    WallStep step(Renderer& renderer);

    /// Fades in the show that has just taken the place of the other.
    /// @param frame  the last step's frame
    void fade(Frame& frame);

    /// A film's tapestry takes the place of the wall, if there is one and it was woven from the film as it is
    /// now.
    /// @param shot  the film's shot with which the view of the tapestry begins
    /// @return false: there is no such tapestry
    bool open_tapestry(const RecordList::Record& film, std::size_t shot);

    /// A tapestry takes the place of the wall.
    /// @param options  without the sources' number and the waiting, which are the stage's
    /// @throws std::runtime_error, std::system_error  naming the index that cannot be read
    void show_tapestry(const std::filesystem::path& directory, TapestryPlaybackOptions options);

    /// The wall goes on where it was left, if the tapestry is over.
    /// @return the sources that the tapestry used
    std::vector<SourceId> leave_finished_tapestry();

    /// Another renderer is used from now on: it has no pictures.
    void forget_uploads();

  private:
    const Settings& settings_;  // outlive this
    std::uint64_t owner_;
    bool awaits_tiles_;
    Vec2 canvas_{1920, 1080};
    std::unique_ptr<Show> wall_;
    std::unique_ptr<TapestryPlayback> tapestry_;  // none: the wall is shown
    Frame wall_frame_;                            // the wall's last, shown behind a tapestry that fades in
    bool has_switched_ = false;                   // false: nothing has taken the place of the first wall yet
    std::chrono::nanoseconds switched_{0};        // time of the last switch
    std::chrono::nanoseconds away_{0};            // time that tapestries were shown, in all
    std::chrono::nanoseconds time_{0};  // the wall's time; while a tapestry is shown, the tapestry's
};

}  // namespace vitrine::player
