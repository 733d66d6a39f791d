#pragma once

#include "player/input/gesture.hpp"
#include "player/scene/tapestry/tapestry_view.hpp"

#include <chrono>
#include <optional>

namespace vitrine::player {

struct TapestryPace {
    std::chrono::nanoseconds zoom =
        std::chrono::milliseconds(600);  // of a step from level to level (paper, 6)
    std::chrono::nanoseconds glide =
        std::chrono::milliseconds(350);  // in which a flung strip loses 63 % of its speed
    std::chrono::nanoseconds patience = std::chrono::seconds(8);  // without a touch, then it moves by itself
    std::chrono::nanoseconds dwell = std::chrono::seconds(10);    // at a level, moving by itself
    double drift = 0.05;  // of the strip's visible width a second, moving by itself
};

/// How a view of a tapestry moves: with fingers, on after them, from level to level, and by itself where
/// nobody touches it: to and fro through the film, nearer and farther. Knows no clock.
class TapestryMotion {
  public:
    TapestryMotion(const TapestryView& view, const TapestryPace& pace) : view_(view), pace_(pace) {}

    /// Drags, flicks, pinches, the wheel and keys; others are ignored.
    void handle_gesture(const Gesture& gesture, const TapestryPlace& place);

    /// Somebody is there: it does not begin to move by itself for a while.
    void touch() { is_touched_ = true; }

    /// @param now  never goes back
    const TapestryView& advance(std::chrono::nanoseconds now, const TapestryPlace& place);

    const TapestryView& view() const { return view_; }

    bool is_by_itself() const { return is_by_itself_; }

    /// Where the view goes to: > 0 to the right.
    double direction() const;

  private:
    struct Zoom {
        double from = 0, to = 0;
        double at = 0;  // canvas px, of what stays where it is
        std::chrono::nanoseconds began{0};
        bool has_begun = false;
    };

    void zoom_to(double level, double at);
    void settle(double at);
    void go_on_zooming(std::chrono::nanoseconds now, const TapestryPlace& place);
    void glide(std::chrono::nanoseconds passed, const TapestryPlace& place);
    void go_by_itself(std::chrono::nanoseconds now, std::chrono::nanoseconds passed,
                      const TapestryPlace& place);

    TapestryView view_;
    TapestryPace pace_;
    std::optional<Zoom> zoom_;
    double speed_ = 0;  // of the strip, canvas px a second to the right
    bool is_touched_ = true;
    bool is_by_itself_ = false;
    double way_ = 1;     // by itself: 1: on through the film, -1: back
    double nearer_ = 1;  // by itself: 1: to finer levels, -1: to coarser ones
    double pinched_at_ = 0;
    std::chrono::nanoseconds touched_{0};
    std::chrono::nanoseconds turned_{0};  // when it came to this level by itself
    std::optional<std::chrono::nanoseconds> last_;
};

}  // namespace vitrine::player
