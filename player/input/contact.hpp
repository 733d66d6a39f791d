#pragma once

#include "base/geometry/vec2.hpp"

#include <chrono>
#include <variant>

namespace vitrine::player {

/// A change of one finger on the panel, or of a mouse whose button is held.
struct Contact {
    enum class Kind { down, move, up, cancel };  // cancel: the panel takes the contact back, it was no finger

    Kind kind = Kind::down;
    int finger = 0;  // number among the fingers that touch at the same time
    Vec2 at;         // canvas px; not used by `up` and `cancel`
    std::chrono::nanoseconds time{0};
    bool is_told = false;  // another box told it: nothing is known of the finger after its last contact

    bool operator==(const Contact&) const = default;
};

/// A turn of a mouse wheel.
struct Wheel {
    double notches = 0;  // > 0: away from the user
    Vec2 at;             // the pointer, canvas px
    std::chrono::nanoseconds time{0};

    bool operator==(const Wheel&) const = default;
};

enum class Key { left, right, nearer, farther, select, back, undo };

struct KeyPress {
    Key key = Key::select;
    std::chrono::nanoseconds time{0};

    bool operator==(const KeyPress&) const = default;
};

/// An input of a visitor. All times are from one clock and never go back.
using InputEvent = std::variant<Contact, Wheel, KeyPress>;

}  // namespace vitrine::player
