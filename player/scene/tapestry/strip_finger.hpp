#pragma once

#include "player/input/gesture.hpp"
#include "player/scene/tapestry/keyframe_edit.hpp"
#include "player/scene/tapestry/tapestry_motion.hpp"
#include "player/scene/tapestry/tapestry_picture.hpp"
#include "player/scene/tapestry/tapestry_preview.hpp"

#include <chrono>
#include <optional>

namespace vitrine::player {

/// The parts of a tapestry that a visitor moves. Lent for the call.
struct TouchedStrip {
    TapestryPlace place;
    const TapestryBoxes& boxes;
    FilmSpans& spans;
    TapestryMotion& motion;
    TapestryPreview& preview;
    KeyframeEdit* edit = nullptr;  // none: the keyframes are not edited
};

/// A visitor's finger on a tapestry.
///
/// A tap plays the picture under the finger: the film from its moment on above the strip, and the picture in
/// place. A hold plays it in place. While a finger drags, the film above shows the moment under it; letting
/// go plays from there. A finger that has rested before, that has taken the line of the film's time, or that
/// finds the whole film in view, goes over the strip; any other takes the strip along. Near an edge of the
/// screen the strip comes towards a finger that goes over it.
///
/// Where keyframes are edited, a tap on a picture of the strip strikes it; a finger that lets go lets the
/// film stand at its moment, and a tap on the film makes the moment that it shows a keyframe; a tap below the
/// strip takes back the choice whose mark is there. Knows no clock.
class StripFinger {
  public:
    void handle_gesture(const Gesture& gesture, const TouchedStrip& strip);

    /// Call with each frame. @param now  never goes back
    void advance(std::chrono::nanoseconds now, const TouchedStrip& strip);

    /// True once a visitor has closed the tapestry.
    bool has_closed() const { return has_closed_; }

    /// True: what plays above is what a visitor has asked for.
    bool has_chosen() const { return has_chosen_; }

    /// Call when that is over.
    void forget_choice() { has_chosen_ = false; }

    /// The picture that a visitor has touched last; it plays in place.
    const StripPicture& touched() const { return touched_; }

  private:
    void tap(const Gesture& tap, const TouchedStrip& strip);
    void press(Key key, const TouchedStrip& strip);
    void edit(const Gesture& tap, const TouchedStrip& strip);
    void play_in_place(Vec2 at, const TouchedStrip& strip);
    void drag(const Gesture& drag, const TouchedStrip& strip);
    void let_go(const Gesture& end, const TouchedStrip& strip);
    void pinch(const Gesture& pinch, const TouchedStrip& strip);
    bool goes_over(const Gesture& drag, const TouchedStrip& strip) const;

    StripPicture touched_;
    std::optional<Vec2> dragged_to_;  // canvas px; none: no finger drags the strip
    bool has_rested_ = false;         // the finger is down and has been held in place
    bool goes_over_strip_ = false;    // the finger that drags does not take the strip along
    double pinched_ = 1;              // total factor of the pinch, at the coarsest level
    std::optional<double> line_x_;    // canvas px; the line of the film's time in the last frame
    std::optional<std::chrono::nanoseconds> shown_;     // the film's time in the last frame
    std::optional<std::chrono::nanoseconds> standing_;  // the film stands there; none: it plays
    std::optional<std::chrono::nanoseconds> last_;      // the last advance()
    bool has_chosen_ = false;
    bool has_closed_ = false;
};

}  // namespace vitrine::player
