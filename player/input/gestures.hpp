#pragma once

#include "player/input/gesture.hpp"

#include <deque>
#include <map>
#include <optional>
#include <vector>

namespace vitrine::player {

/// The limits of gestures. Lengths in canvas px.
struct GestureRules {
    double slop = 12;   // a finger that moves farther drags
    double fast = 600;  // px a second; a finger that is lifted at this speed flicks
    std::chrono::nanoseconds hold = std::chrono::milliseconds(500);   // a finger that rests this long holds
    std::chrono::nanoseconds twice = std::chrono::milliseconds(350);  // longest pause in a double tap
    std::chrono::nanoseconds trail =
        std::chrono::milliseconds(80);  // the finger's speed is measured over this last time
    double notch = 1.25;                // factor for one notch of the wheel
};

/// The rules for a canvas of this size, px: a finger covers the same share of every panel.
GestureRules gesture_rules(Vec2 canvas);

/// Recognises gestures in a visitor's input. Knows no clock: the time is passed in.
class Gestures {
  public:
    explicit Gestures(const GestureRules& rules = {}) : rules_(rules) {}

    /// Sets the rules for fingers that come down from now on.
    void set_rules(const GestureRules& rules) { rules_ = rules; }

    void handle_input(const InputEvent& event);

    /// The gestures since the last call, in order.
    /// @param now  not before the last event
    std::vector<Gesture> next_gestures(std::chrono::nanoseconds now);

    /// True: a finger touches the panel.
    bool is_touched() const { return !fingers_.empty(); }

  private:
    enum class State {
        idle,
        pressed,
        holding,
        dragging,
        pinching,
        over
    };  // over: ignores everything until all fingers are lifted

    struct Point {
        Vec2 at;
        std::chrono::nanoseconds time{0};
    };

    struct Finger {
        Vec2 from;
        Vec2 at;
        std::chrono::nanoseconds since{0};
        std::deque<Point> trail;
    };

    void handle(const Contact& contact);
    void handle(const Wheel& wheel);
    void handle(const KeyPress& press);
    void put_down(const Contact& contact);
    void move(const Contact& contact);
    void drag(Finger& finger, Vec2 before);
    void pinch();
    void lift(const Contact& contact);
    void tap(const Finger& finger, std::chrono::nanoseconds time);
    void end_hold_or_drag(const Finger& finger, std::chrono::nanoseconds time, bool may_flick);
    void recognise_hold(std::chrono::nanoseconds now);
    Vec2 velocity(const Finger& finger, std::chrono::nanoseconds now) const;
    Vec2 middle() const;
    double spread() const;

    GestureRules rules_;
    State state_ = State::idle;
    std::map<int, Finger> fingers_;
    Vec2 middle_;                  // the point between two fingers, at the last contact
    double spread_ = 1;            // px between two fingers, at the last contact
    std::optional<Point> tapped_;  // the last tap, if it may become a double tap
    std::vector<Gesture> gestures_;
};

}  // namespace vitrine::player
