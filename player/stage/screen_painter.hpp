#pragma once

#include "base/settings/settings.hpp"
#include "player/display/screen.hpp"
#include "player/playback/source_pool.hpp"
#include "player/render/renderer.hpp"
#include "player/render/view.hpp"
#include "player/scene/frame.hpp"

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

namespace vitrine::player {

/// Draws a stage's frames on its screens. Knows which pictures the renderer has, and which frame each screen
/// shows: a screen is drawn only when something on it is new.
///
/// Each screen is drawn by itself, not copied from one picture: the result is sharp at every size. With
/// llvmpipe it costs half as much as copying for one screen, the same for two and an eighth more for three
/// (bench/render).
class ScreenPainter {
  public:
    /// @param settings, sources  outlive this
    ScreenPainter(const Settings& settings, const SourcePool& sources)
        : settings_(settings), sources_(sources) {}

    /// @param screens  lent until the next call
    void set_screens(std::vector<Screen*> screens);

    std::span<Screen* const> screens() const { return screens_; }

    /// The canvas that fills the largest screen, px. @pre there is a screen
    Vec2 largest_canvas() const;

    /// The point of a canvas that is seen at a place of a screen, given as a share of the screen.
    Vec2 canvas_point(const Screen& screen, Vec2 canvas, Vec2 share) const;

    /// Shows the frame on every screen that can take a picture and does not show it already.
    /// @param now             since the player's start
    /// @param waits_for_wall  no screen is given a picture through which the idle picture is seen
    void paint(const Frame& frame, std::chrono::nanoseconds now, Renderer& renderer, bool waits_for_wall);

    /// The source is gone; the renderer forgets its picture.
    void forget(SourceId source, Renderer& renderer);

    /// Another renderer is used from now on: it has no pictures.
    void forget_uploads() { uploaded_.clear(); }

  private:
    View view_on(const Screen& screen) const;
    bool upload(const Frame& frame, Renderer& renderer);
    void number(const Frame& frame, bool is_new, bool is_idle);
    void draw(const Frame& frame, Screen& screen, Renderer& renderer) const;

    const Settings& settings_;   // outlive this
    const SourcePool& sources_;  // outlives this
    std::vector<Screen*> screens_;
    std::map<SourceId, std::shared_ptr<const void>> uploaded_;  // the renderer's pictures; shared with it
    Frame drawn_;                                               // the frame that was numbered last
    std::uint64_t number_ = 0;                                  // counts the frames that look different
    std::map<const Screen*, std::uint64_t> shown_;              // number of the frame on each screen
};

}  // namespace vitrine::player
