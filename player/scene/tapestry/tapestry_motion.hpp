#pragma once

#include "player/input/gesture.hpp"
#include "player/scene/tapestry/tapestry_view.hpp"

#include <chrono>
#include <optional>

namespace vitrine::player {

struct TapestryPace {
    std::chrono::nanoseconds zoom = std::chrono::milliseconds(600);   // from one level to the next (paper, 6)
    std::chrono::nanoseconds glide = std::chrono::milliseconds(350);  // a flung strip loses 63 % of its speed
    std::chrono::nanoseconds patience = std::chrono::seconds(8);  // without a touch, until it moves by itself
    std::chrono::nanoseconds dwell = std::chrono::seconds(10);  // time at one level while it moves by itself
    double drift = 0.05;  // share of the visible width per second while it moves by itself
};

/// Moves the view of a tapestry: with the fingers, after a flick, from level to level. If nobody touches it,
/// it moves by itself: to and fro through the film, to finer and to coarser levels. Knows no clock.
class TapestryMotion {
  public:
    TapestryMotion(const TapestryView& view, const TapestryPace& pace) : view_(view), pace_(pace) {}

    /// Moves the view by drags, flicks, pinches, the wheel and keys; ignores other gestures.
    void handle_gesture(const Gesture& gesture, const TapestryPlace& place);

    /// Another tapestry of the same film takes the place of the one that was moved: see
    /// view_like().
    void move_to(const TapestryPlace& to, const TapestryPlace& from);

    /// Shows a view that was moved elsewhere.
    void show(const TapestryView& view) { view_ = view; }

    /// Notes a touch: the view does not move by itself for `patience`.
    void touch() { touched_.reset(); }

    /// Sets the moment of the film that plays beside the strip; none: nothing plays. The strip goes along, so
    /// that the moment stays in view, unless a visitor has moved the strip away from it.
    void follow(std::optional<std::chrono::nanoseconds> playing) { followed_ = playing; }

    /// @param now  never goes back
    const TapestryView& advance(std::chrono::nanoseconds now, const TapestryPlace& place);

    const TapestryView& view() const { return view_; }

    bool is_by_itself() const { return reached_level_.has_value(); }

    /// Direction in which the view moves: > 0 to the right, < 0 to the left, 0: it rests.
    double direction() const;

  private:
    enum class Hold {
        free,  // the strip goes along with the film
        held,  // a finger is on the strip
        away,  // a visitor has moved the strip away from what plays
    };

    struct Zoom {
        double from = 0, to = 0;                        // levels
        double at = 0;                                  // canvas px of the point that stays in place
        std::optional<std::chrono::nanoseconds> began;  // none: it starts with the next advance()
    };

    void zoom_to(double level, double at);
    void zoom_by_one(bool is_nearer, double at);
    void settle(double at);
    void go_on_zooming(std::chrono::nanoseconds now, const TapestryPlace& place);
    void glide(std::chrono::nanoseconds passed, const TapestryPlace& place);
    void keep_in_view(std::chrono::nanoseconds passed, const TapestryPlace& place);
    void go_by_itself(std::chrono::nanoseconds now, std::chrono::nanoseconds passed,
                      const TapestryPlace& place);

    TapestryView view_;
    TapestryPace pace_;
    std::optional<Zoom> zoom_;
    double speed_ = 0;       // the tapestry's speed, canvas px per second to the right
    double way_ = 1;         // by itself: 1: forwards through the film, -1: backwards
    double level_step_ = 1;  // by itself: 1: to finer levels, -1: to coarser ones
    double pinched_at_ = 0;  // canvas px; the middle of the pinch
    std::optional<std::chrono::nanoseconds> followed_;  // the film's moment that plays
    Hold hold_ = Hold::free;
    std::optional<std::chrono::nanoseconds> touched_;  // the last touch; none: since the last advance()
    std::optional<std::chrono::nanoseconds>
        reached_level_;  // by itself: time of reaching the level; none: it does not move by itself
    std::optional<std::chrono::nanoseconds> last_;  // the last advance()
};

}  // namespace vitrine::player
