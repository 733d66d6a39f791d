#pragma once

#include "player/input/contact.hpp"

namespace vitrine::player {

/// The meaning of a visitor's input. All lengths in canvas px.
///
/// A new gesture is recognised in gestures.cpp. A show handles it (handle_gesture) or, if it opens something,
/// the stage does (gesture_dispatch).
struct Gesture {
    enum class Kind {
        tap,
        double_tap,  // follows the second of two taps
        hold,        // a finger stays in place; ends with `release`, or continues as `drag`
        release,     // the holding finger was lifted
        drag,        // a finger moves; ends with `drop` or `flick`
        drop,        // the dragging finger was lifted, or a second finger came down
        flick,       // the dragging finger was lifted while it moved fast
        pinch,       // two fingers move, by `factor` and `moved`; ends with `pinch_end`
        pinch_end,
        wheel,  // by `factor`
        key,
    };

    Kind kind = Kind::tap;
    Vec2 at;                // the finger, the middle of two fingers, or the pointer
    Vec2 from;              // the place where the finger came down
    Vec2 moved;             // drag and pinch: way since the last gesture
    Vec2 velocity;          // flick: px a second
    double factor = 1;      // pinch and wheel: growth since the last gesture, > 0
    Key key = Key::select;  // key: the pressed key
};

}  // namespace vitrine::player
