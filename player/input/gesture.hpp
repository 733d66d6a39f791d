#pragma once

#include "player/input/contact.hpp"

#include <cstdint>

namespace vitrine::player {

/// A thing that is touched: a shot, a strip. Fingers on the same subject make one gesture together; each
/// finger on no subject makes one of its own.
using Subject = std::uint64_t;

constexpr Subject no_subject = 0;
constexpr Subject whole_show = ~Subject{0};  // all of what is shown, such as the strip of a tapestry

/// The meaning of a visitor's input. All lengths in canvas px.
///
/// A new gesture is recognised in touch_recogniser.cpp. A show handles it (handle_gesture) or, if it opens
/// something, the stage does (gesture_dispatch).
struct Gesture {
    enum class Kind {
        tap,
        double_tap,  // follows the second of two taps
        hold,        // a finger stays in place; ends with `release` or `lost`, or continues as `drag`
        release,     // the holding finger was lifted, or a second finger came down
        drag,        // a finger moves; ends with `drop`, `flick` or `lost`
        drop,        // the dragging finger was lifted, or a second finger came down
        flick,       // the dragging finger was lifted while it moved fast
        lost,        // the panel took the contact back, or it rested too long: nobody meant anything
        pinch,       // two fingers move, by `factor` and `moved`; ends with `pinch_end`
        pinch_end,
        wheel,  // by `factor`
        key,
    };

    Kind kind = Kind::tap;
    std::uint64_t touch = 0;  // the same from the first to the last gesture of one touch; never used twice
    Subject subject = no_subject;  // where the touch began
    Vec2 at;                       // the finger, the middle of two fingers, or the pointer
    Vec2 from;                     // the place where the finger came down
    Vec2 moved;                    // drag and pinch: way since the last gesture
    Vec2 velocity;                 // flick: px a second
    double factor = 1;             // pinch and wheel: growth since the last gesture, > 0
    Key key = Key::select;         // key: the pressed key
};

}  // namespace vitrine::player
