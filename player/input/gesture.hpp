#pragma once

#include "player/input/contact.hpp"

namespace vitrine::player {

/// What a visitor means. All lengths canvas px.
struct Gesture {
    enum class Kind {
        tap,
        double_tap,  // follows the second of two taps
        hold,        // a finger stays where it came down; ends with `release`, or goes on as `drag`
        release,     // it was lifted
        drag,        // a finger moves; ends with `drop` or `flick`
        drop,        // it was lifted, or a second one came
        flick,       // it was lifted while it moved fast
        pinch,       // two fingers, by `factor` and `moved`; ends with `pinch_end`
        pinch_end,
        wheel,  // by `factor`
        key,
    };

    Kind kind = Kind::tap;
    Vec2 at;            // the finger, the middle of two, the pointer
    Vec2 from;          // where the finger came down
    Vec2 moved;         // of drag and pinch: since the last one
    Vec2 velocity;      // of flick: px a second
    double factor = 1;  // of pinch and wheel: how much larger since the last one, > 0
    Key key = Key::select;
};

}  // namespace vitrine::player
