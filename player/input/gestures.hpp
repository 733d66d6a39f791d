#pragma once

#include "player/input/gesture.hpp"

#include <deque>
#include <map>
#include <optional>
#include <vector>

namespace vitrine::player {

/// From when on a contact means something. Lengths canvas px.
struct GestureRules {
    double slop = 12;   // that a finger moves without meaning it
    double fast = 600;  // a second, of a flick
    std::chrono::nanoseconds hold = std::chrono::milliseconds(500);
    std::chrono::nanoseconds twice = std::chrono::milliseconds(350);  // between two taps that are one
    std::chrono::nanoseconds trail = std::chrono::milliseconds(80);   // of a finger that its speed is told by
    double notch = 1.25;                                              // factor of the wheel
};

/// The rules for a canvas of this size: a finger covers the same share of every panel.
GestureRules gesture_rules(Vec2 canvas);

/// Makes gestures of contacts. Knows no clock: it is told the time.
class Gestures {
  public:
    explicit Gestures(const GestureRules& rules = {}) : rules_(rules) {}

    /// For a finger that comes down from now on.
    void set_rules(const GestureRules& rules) { rules_ = rules; }

    void handle_input(const InputEvent& event);

    /// What has been meant since the last call, in order.
    /// @param now  not before the last event
    std::vector<Gesture> next_gestures(std::chrono::nanoseconds now);

    /// Whether a finger touches.
    bool is_touched() const { return !fingers_.empty(); }

  private:
    enum class State { idle, pressed, holding, dragging, pinching, over };  // over: until all are lifted

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

    void follow(const Contact& contact);
    void follow(const Wheel& wheel);
    void follow(const KeyPress& press);
    void come_down(const Contact& contact);
    void move(const Contact& contact);
    void move_one(Finger& finger, Vec2 before);
    void move_two();
    void lift(const Contact& contact);
    void tap(const Finger& finger, std::chrono::nanoseconds time);
    void end(const Finger& finger, std::chrono::nanoseconds time, bool may_flick);
    void look_for_hold(std::chrono::nanoseconds now);
    Vec2 velocity(const Finger& finger, std::chrono::nanoseconds now) const;
    Vec2 middle() const;
    double spread() const;

    GestureRules rules_;
    State state_ = State::idle;
    std::map<int, Finger> fingers_;
    Vec2 middle_;        // of two fingers, when last looked at
    double spread_ = 1;  // likewise
    std::optional<Point> tapped_;
    std::vector<Gesture> meant_;
};

}  // namespace vitrine::player
