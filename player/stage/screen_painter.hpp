#pragma once

#include "base/settings/settings.hpp"
#include "player/display/screen.hpp"
#include "player/playback/source_pool.hpp"
#include "player/render/renderer.hpp"
#include "player/render/view.hpp"
#include "player/scene/frame.hpp"
#include "player/stage/output_canvas.hpp"

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::player {

/// Draws a stage's frames on its screens: the whole canvas on each, or the part that `output.canvas` gives
/// it. Knows the renderer's pictures and each screen's frame: a screen is drawn only if something on it is
/// new.
///
/// Each screen is drawn from the frame itself, not copied from another screen: the result is sharp at every
/// size. With llvmpipe this costs half as much as copying for one screen, the same for two and an eighth more
/// for three (bench/render).
class ScreenPainter {
  public:
    /// @param settings, sources  outlive this
    /// @param others            outputs of other boxes on the same canvas, as they are now
    ScreenPainter(const Settings& settings, const SourcePool& sources,
                  std::shared_ptr<const OtherOutputs> others = {})
        : settings_(settings), outputs_(settings, std::move(others)), sources_(sources) {}

    /// @param screens  lent until the next call
    /// @param now      since the player's start
    void set_screens(std::vector<Screen*> screens, std::chrono::nanoseconds now);

    std::span<Screen* const> screens() const { return screens_; }

    /// The parts of the canvas that all outputs show, those of other boxes too, by BOX/OUTPUT.
    std::vector<ActParts> parts() const { return outputs_.parts(); }

    /// Shows the parts of this box in an act from now on.
    void show_parts(const WallAct& act) { outputs_.show_parts(act); }

    /// The canvas that the screens show together, or else the one that fills the largest of them.
    /// None: there is no screen, and no other box shows a part.
    std::optional<Canvas> canvas() const;

    /// True: other boxes show the canvas, or parts of it.
    bool has_others() const { return outputs_.has_others(); }

    /// The canvas of screens of this size, px, while none is open.
    Canvas expected_canvas(int width, int height);

    /// The canvas point that is seen at a place of a screen. @param share  the place as shares of the
    /// screen's sides
    Vec2 canvas_point(const Screen& screen, Vec2 canvas, Vec2 share) const;

    /// Shows the frame on every screen that is ready and does not show it yet.
    /// @param now             since the player's start
    /// @param renderer        nullptr: there is none, and no screen
    /// @param waits_for_wall  draws no frame in which the idle picture would be seen
    void paint(const Frame& frame, std::chrono::nanoseconds now, Renderer* renderer, bool waits_for_wall);

    /// Draws guides for placing the screens above all frames, or ends that.
    void show_guides(bool is_on);

    /// Call when the source is gone: the renderer drops its picture. @param renderer  nullptr: there is none
    void forget(SourceId source, Renderer* renderer);

    /// Call after the renderer was replaced: all pictures must be uploaded again.
    void forget_uploads() { uploaded_.clear(); }

  private:
    bool upload(const Frame& frame, Renderer& renderer);
    void number(const Frame& frame, bool is_new, bool is_idle);
    void draw(const Frame& frame, Screen& screen, Renderer& renderer);
    WordItem guide(const Screen& screen, Vec2 canvas, Vec2 origin);

    struct Guide {
        GuideView view;
        std::shared_ptr<const WordPicture> picture;  // shared with the frames that show it
    };

    const Settings& settings_;  // outlive this
    OutputCanvas outputs_;
    const SourcePool& sources_;  // outlives this
    std::vector<Screen*> screens_;
    std::map<SourceId, std::shared_ptr<const void>> uploaded_;  // the renderer's pictures; shared with it
    Frame drawn_;                                               // the frame that got the last number
    std::uint64_t number_ = 0;                                  // counts the frames that look different
    std::map<const Screen*, std::uint64_t> shown_;              // number of the frame on each screen
    bool has_guides_ = false;
    std::map<std::string, Guide> guides_;  // by the screens' names
};

}  // namespace vitrine::player
