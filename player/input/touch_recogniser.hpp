#pragma once

#include "player/input/gesture.hpp"

#include <deque>
#include <map>
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
    std::chrono::nanoseconds rest = std::chrono::seconds(60);  // a contact that rests this long is no finger
    double notch = 1.25;                                       // factor for one notch of the wheel
};

/// Recognises one gesture after another in the fingers on one subject: one finger taps, holds or drags, two
/// pinch. When one of two is lifted, the other may drag on. More fingers are ignored. Knows no clock.
class TouchRecogniser {
  public:
    /// @param number  Gesture::touch of its gestures
    TouchRecogniser(const GestureRules& rules, Subject subject, std::uint64_t number)
        : rules_(rules), subject_(subject), number_(number) {}

    void put_down(const Contact& contact, std::vector<Gesture>& gestures);
    void move(const Contact& contact, std::vector<Gesture>& gestures);

    /// Handles `up` and `cancel`.
    void lift(const Contact& contact, std::vector<Gesture>& gestures);

    /// Recognises a hold, and gives up fingers that have rested too long. @param now  never goes back
    void advance(std::chrono::nanoseconds now, std::vector<Gesture>& gestures);

    bool has_fingers() const { return !fingers_.empty(); }

    bool has_finger(int finger) const { return fingers_.contains(finger); }

  private:
    enum class State {
        pressed,
        holding,
        dragging,
        pinching,
        left,  // one of two fingers was lifted; the other neither taps nor holds
    };

    struct Point {
        Vec2 at;
        std::chrono::nanoseconds time{0};
    };

    struct Finger {
        Vec2 from;
        Vec2 at;
        std::chrono::nanoseconds since{0};
        Point rested;  // the last place and time at which it had moved farther than the slop
        std::deque<Point> trail;
        bool is_told = false;  // as in Contact
    };

    Gesture gesture(Gesture::Kind kind, const Finger& finger) const;
    void recognise_hold(std::chrono::nanoseconds known, std::vector<Gesture>& gestures);
    void follow(Finger& finger, const Contact& contact) const;
    void drag(Finger& finger, Vec2 before, std::vector<Gesture>& gestures);
    void pinch(std::vector<Gesture>& gestures);
    void end(const Finger& finger, const Contact& contact, std::vector<Gesture>& gestures) const;
    Vec2 velocity(const Finger& finger, std::chrono::nanoseconds now) const;
    Vec2 middle() const;
    double spread() const;

    GestureRules rules_;
    Subject subject_;
    std::uint64_t number_;
    State state_ = State::pressed;
    std::map<int, Finger> fingers_;
    Vec2 middle_;        // the point between two fingers, at the last contact
    double spread_ = 1;  // px between two fingers, at the last contact
};

}  // namespace vitrine::player
