#pragma once

#include "base/state/record.hpp"
#include "player/scene/frame.hpp"

#include <chrono>
#include <optional>
#include <span>
#include <string>

namespace vitrine::player {

/// A shot of a film that is on the wall and may be heard.
struct AudibleShot {
    SourceId source = 0;
    std::string path;                   // relative to the media folder
    std::chrono::nanoseconds begin{0};  // half-open [begin, end) in the film
    std::chrono::nanoseconds end{0};
    std::optional<StoredSound> stored;
    std::chrono::nanoseconds local{0};  // since the shot first appeared; it plays in a loop
    double area = 0;                    // area of its picture on the wall, canvas px squared
    Vec2 middle = {};                   // of its picture, canvas px
    bool is_elsewhere = false;          // another box of the wall lets it be heard

    std::chrono::nanoseconds duration() const { return end - begin; }
};

/// Chooses the one film to be heard, because nobody understands two at once: the one that came first, of
/// several that came together the largest. One that is less than half as large as another (which a visitor
/// has tapped) is not heard. All boxes of a wall choose the same, whenever they have joined it.
/// @return nullptr: no shot is given
const AudibleShot* chosen_sound(std::span<const AudibleShot> shots);

}  // namespace vitrine::player
