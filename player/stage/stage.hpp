#pragma once

#include "base/settings/settings.hpp"
#include "player/display/picture.hpp"
#include "player/display/screen.hpp"
#include "player/input/gestures.hpp"
#include "player/layout/plan/planner.hpp"
#include "player/playback/source_pool.hpp"
#include "player/render/renderer.hpp"
#include "player/scene/chosen_sound.hpp"
#include "player/scene/show.hpp"
#include "player/stage/tapestry_playback.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vitrine::player {

struct StageOptions {
    std::uint64_t number = 0;  // the owner of its sources, another for each stage
    std::string folder;        // below the media folder; empty: all of it

    bool awaits_sources = false;  // the clock stands still until the layout and the sources are there
};

/// One wall and the screens that show it. Its canvas is that of the largest screen; each other one shows the
/// same in its own resolution, between black bars where its shape is another. While no screen shows it, its
/// time stands still.
///
/// Each screen is drawn by itself, not copied from one picture: that is sharp at every size, and with
/// llvmpipe costs half of it for one screen, the same for two and an eighth more for three
/// (bench/render).
class Stage {
  public:
    /// @param settings, sources  outlive this
    Stage(const Settings& settings, StageOptions options, SourcePool& sources);

    const std::string& folder() const { return options_.folder; }

    /// The folder that a visitor looks into; empty: all folders.
    const std::string& opened_folder() const { return opened_; }

    /// @param records  all that may be shown, ordered by path; the stage takes what is in its folder
    void set_catalogue(const RecordList& records, const ShowHints& hints = {});

    /// Has the wall laid out for a screen of this size, px, which is still being opened.
    void expect_screen(int width, int height);

    /// @param screens  lent until the next call
    /// @param now      since the player's start
    void set_screens(std::vector<Screen*> screens, std::chrono::nanoseconds now);

    std::span<Screen* const> screens() const { return screens_; }

    /// What a visitor does, canvas px, times since the player's start.
    void take(const InputEvent& event) { gestures_.take(event); }

    /// The canvas point that is seen at a place of one of its screens, given as a share of that screen.
    Vec2 canvas_point(const Screen& screen, Vec2 share) const;

    /// One picture on every screen that can take one and does not show it already.
    /// @param waits_for_wall  no screen is given a picture through which the idle picture is seen
    void show(std::chrono::nanoseconds now, Renderer& renderer, bool waits_for_wall = false);

    /// Another renderer is used from now on: it has none of the pictures.
    void forget_uploads();

    /// A film's tapestry is shown in place of the wall, which waits meanwhile.
    /// @param directory  of the tapestry
    /// @param patience   without a touch, then the wall comes back; none: never
    /// @throws std::runtime_error, std::system_error  naming the index that cannot be read
    void show_strip(const std::filesystem::path& directory, std::optional<std::chrono::nanoseconds> patience);

    void set_controls(const ShowControls& controls);

    /// The shots on its screens, by the last show(), that are to be heard by what names and folders say;
    /// none while the wall is paused.
    std::vector<AudibleShot> audible() const;

    /// What is on the wall by the last show().
    const Frame& frame() const { return frame_; }

    /// That once more, small. @param longest  px of its longest side
    Picture picture(int longest, Renderer& renderer) const;

    /// How many shots are on the wall.
    std::size_t count() const { return show_->count(); }

    std::vector<SlotShot> standing() const { return show_->standing(); }

  private:
    void handle_source_event(const SourceEvent& event);
    void set_canvas(Vec2 canvas);
    void take_gestures(std::chrono::nanoseconds now);
    bool opens_folder(const Gesture& gesture) const;
    void show_folder(const std::string& folder);
    bool opens_strip(const Gesture& gesture);
    void show_strip(const std::filesystem::path& directory, StripStageOptions options);
    void show_wall(Renderer& renderer);
    WallStep one_step(Renderer& renderer);
    void fade_in(Frame& frame) const;
    WallStep next_step(Renderer& renderer);
    void carry_out(const WallStep& step, Renderer& renderer);
    void take_layout();
    void ask(const WallPlan& wall);
    void note_film(const ShotRequest& request);
    void draw(Frame& frame, std::chrono::nanoseconds now, Renderer& renderer, bool waits_for_wall);
    bool upload(const Frame& frame, Renderer& renderer);

    const Settings& settings_;  // outlives this
    StageOptions options_;
    SourcePool& sources_;  // outlives this
    Vec2 canvas_{1920, 1080};
    std::unique_ptr<Show> show_;
    Gestures gestures_;
    ShowHints hints_;
    RecordList records_;                     // of its folder
    std::map<SourceId, AudibleShot> films_;  // those that were asked for
    bool is_paused_ = false;
    std::string opened_;  // the folder that a visitor looks into; empty: none
    std::chrono::nanoseconds touched_{0};
    std::unique_ptr<StripStage> strip_;  // in place of the wall; none: the wall is shown
    Frame behind_;                       // what was shown before the strip
    std::chrono::nanoseconds came_{0};   // when the strip or the wall came, with a fade
    bool fades_ = false;
    double pinched_ = 1;  // by how much, on the wall
    Planner planner_;
    std::vector<Screen*> screens_;
    Frame frame_;                         // the last
    std::chrono::nanoseconds hidden_{0};  // that no screen showed it, in all
    std::chrono::nanoseconds away_{0};    // that a strip was shown in place of the wall, in all
    std::optional<std::chrono::nanoseconds> hidden_since_{0};   // none: a screen shows it
    std::chrono::nanoseconds time_{0};                          // of the wall
    std::map<SourceId, std::shared_ptr<const void>> uploaded_;  // what the renderer has; shared with it
    Frame drawn_;                                               // as of the last picture
    std::uint64_t picture_ = 0;                                 // counts those that differ
    std::map<const Screen*, std::uint64_t> shown_;              // which one each screen has
    std::shared_ptr<const SourceListener> listener_;            // shared: its pool calls it while it exists
};

}  // namespace vitrine::player
