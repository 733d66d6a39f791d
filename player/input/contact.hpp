#pragma once

#include "base/geometry/vec2.hpp"

#include <chrono>
#include <variant>

namespace vitrine::player {

/// What became of one finger, or of a mouse whose button is held.
struct Contact {
    enum class Kind { down, move, up, cancel };  // cancel: it was no finger after all

    Kind kind = Kind::down;
    int finger = 0;  // tells those apart that touch at the same time
    Vec2 at;         // canvas px; of `up` and `cancel` not used
    std::chrono::nanoseconds time{0};

    friend bool operator==(const Contact&, const Contact&) = default;
};

/// A mouse wheel.
struct Wheel {
    double notches = 0;  // > 0: away from the hand
    Vec2 at;             // of the pointer, canvas px
    std::chrono::nanoseconds time{0};

    friend bool operator==(const Wheel&, const Wheel&) = default;
};

enum class Key { left, right, nearer, farther, select, back };

struct KeyPress {
    Key key = Key::select;
    std::chrono::nanoseconds time{0};

    friend bool operator==(const KeyPress&, const KeyPress&) = default;
};

/// What a visitor's hands do. Times are of one clock and never go back.
using InputEvent = std::variant<Contact, Wheel, KeyPress>;

}  // namespace vitrine::player
