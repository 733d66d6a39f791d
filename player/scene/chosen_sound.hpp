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

/// Chooses the one film to be heard, because nobody understands two at once. Keeps the current film unless
/// another one is at least twice as large (a visitor has tapped it); without a current film, chooses the
/// largest.
/// @param heard  the source that is heard at present
/// @return nullptr: no shot is given
const AudibleShot* chosen_sound(std::span<const AudibleShot> shots, std::optional<SourceId> heard);

}  // namespace vitrine::player
