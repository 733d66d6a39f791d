#pragma once

#include "player/input/contact.hpp"
#include "player/layout/canvas.hpp"
#include "player/scene/frame.hpp"
#include "player/stage/stage_files.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vitrine {

struct Settings;

}

namespace vitrine::player {

class AudibleFilms;
class FolderWords;
class GestureDispatch;
struct OtherOutputs;
class Renderer;
class Screen;
class ScreenPainter;
class Show;
class ShowSwitch;
class SourcePool;
class WallPlanner;
struct AudibleShot;
struct ShowControls;
struct SourceListener;
struct WallStep;

struct StageOptions {
    std::uint64_t number = 0;     // owner number of the stage's sources; different for each stage
    std::string folder;           // below the media folder; empty: the whole media folder
    bool awaits_sources = false;  // the clock stands still until the layout and the sources are ready
    std::shared_ptr<const OtherOutputs>
        others;  // outputs of other boxes, as they are now; none: there are none
};

/// One show and the screens that show it. `output.canvas` determines the canvas, and the part of it that each
/// screen shows; else the largest screen does. Every other screen shows the whole canvas in its own
/// resolution, between black bars if its shape differs. While no screen shows the stage, its time stands
/// still, unless it shares its time with other boxes. A stage that leads others goes on for their screens.
class Stage {
  public:
    /// @param settings, sources  outlive this
    Stage(const Settings& settings, StageOptions options, SourcePool& sources);
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;
    Stage(Stage&&) = delete;
    Stage& operator=(Stage&&) = delete;
    ~Stage();

    /// The files that pass the filters: the stage's folder and a folder that a visitor has opened.
    const StageFiles& files() const { return files_; }

    /// @param records  all files that may be shown, ordered by path; the stage takes those of its folder
    void set_catalogue(const RecordList& records, const ShowHints& hints = {});

    /// Lays the wall out for a screen of this size, px, while it is still being opened.
    void expect_screen(int width, int height);

    /// @param screens  lent until the next call
    /// @param now      since the player's start
    void set_screens(std::vector<Screen*> screens, std::chrono::nanoseconds now);

    std::span<Screen* const> screens() const;

    /// True: a screen shows the stage, or one of a box that it leads.
    bool is_seen() const;

    /// Handles a visitor's input. @param event  canvas px, time since the player's start
    void handle_input(const InputEvent& event);

    /// The canvas point that is seen at a place of a screen. @param share  the place as shares of the
    /// screen's sides
    Vec2 canvas_point(const Screen& screen, Vec2 share) const;

    /// Shows one frame on every screen that is ready and does not show it yet.
    /// @param renderer        nullptr: there is none, and no screen
    /// @param waits_for_wall  draws no frame in which the idle picture would be seen
    void show(std::chrono::nanoseconds now, Renderer* renderer, bool waits_for_wall = false);

    /// Call after the renderer was replaced: all pictures must be uploaded again.
    void forget_uploads();

    /// Shows a film's tapestry in place of the wall, which waits meanwhile.
    /// @param directory  the tapestry's directory
    /// @param patience   time without a touch until the wall comes back; none: it never does
    /// @throws std::runtime_error, std::system_error  naming the index that cannot be read
    void show_tapestry(const std::filesystem::path& directory,
                       std::optional<std::chrono::nanoseconds> patience);

    void set_controls(const ShowControls& controls);

    /// Draws guides for placing the screens above all, or ends that.
    void show_guides(bool is_on);

    /// The shots in frame() whose hints ask for sound; none while the wall is paused. On a wall of several
    /// boxes one of them lets a shot be heard: the one that shows its middle.
    std::vector<AudibleShot> audible() const;

    /// The frame of the last show().
    const Frame& frame() const { return frame_; }

    Show& wall() const;

  private:
    WallStep next_step(Renderer* renderer);
    void carry_out(const WallStep& step, Renderer* renderer);

    const Settings& settings_;  // outlive this
    bool awaits_sources_;
    SourcePool& sources_;  // outlives this
    StageFiles files_;
    std::unique_ptr<ShowSwitch> shows_;
    std::unique_ptr<GestureDispatch> gestures_;
    std::unique_ptr<WallPlanner> planner_;
    std::unique_ptr<ScreenPainter> painter_;
    std::unique_ptr<AudibleFilms> films_;
    std::unique_ptr<FolderWords> words_;
    bool is_paused_ = false;
    Frame frame_;                         // the last frame
    std::chrono::nanoseconds hidden_{0};  // total time in which no screen showed this stage
    std::optional<std::chrono::nanoseconds> hidden_since_{0};  // none: a screen shows the stage now
    std::shared_ptr<const SourceListener> listener_;           // shared: the pool calls it while it exists
};

}  // namespace vitrine::player
