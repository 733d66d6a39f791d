#pragma once

#include "player/input/touch_recogniser.hpp"

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace vitrine::player {

/// The rules for a canvas of this size, px: a finger covers the same share of every panel.
GestureRules gesture_rules(Vec2 canvas);

/// Recognises the gestures of several people: those on one subject make one gesture together (a pinch), those
/// on different subjects one each. A contact that rests for a minute is ignored until it is lifted. A contact
/// that comes down without having been lifted was lost before. Knows no clock: the time is passed in.
class Gestures {
  public:
    explicit Gestures(const GestureRules& rules = {}) : rules_(rules) {}

    /// Sets the rules for fingers that come down from now on.
    void set_rules(const GestureRules& rules) { rules_ = rules; }

    /// @param subject  for a finger that comes down, and a wheel: what is there
    void handle_input(const InputEvent& event, Subject subject = no_subject);

    /// The gestures since the last call, in order.
    /// @param now  not before the last event
    std::vector<Gesture> next_gestures(std::chrono::nanoseconds now);

    /// True: a finger touches the panel. A contact that is ignored does not count.
    bool is_touched() const { return !touches_.empty(); }

    /// Number of contacts that are followed.
    std::size_t count() const { return fingers_.size(); }

  private:
    using Owner = std::pair<Subject, int>;  // a finger on no subject has a recogniser of its own

    /// A finger that is followed.
    struct FollowedFinger {
        Owner owner;
        std::chrono::nanoseconds since{0};  // when it came down
    };

    struct Tap {
        Vec2 at;
        std::chrono::nanoseconds time{0};
    };

    void handle(const Contact& contact, Subject subject);
    void handle(const Wheel& wheel, Subject subject);
    void handle(const KeyPress& press, Subject subject);
    void put_down(const Contact& contact, Subject subject);
    void advance(std::chrono::nanoseconds now);
    void drop_lifted();
    void find_double_tap(std::chrono::nanoseconds since, std::chrono::nanoseconds now);

    GestureRules rules_;
    std::uint64_t last_touch_ = 0;
    std::map<Owner, TouchRecogniser> touches_;
    std::map<int, FollowedFinger> fingers_;
    std::vector<Tap> taps_;  // the last ones, if they may become double taps
    std::vector<Gesture> gestures_;
};

}  // namespace vitrine::player
