#pragma once

#include "player/input/contact.hpp"
#include "player/scene/acts/box_talk.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine::player {

/// The touches of visitors on a box that follows, for the leader: fingers and wheels, canvas px.
/// @param sent  the box that follows, now
std::string touches_to_json(std::span<const InputEvent> events, const BoxMoment& sent);

/// The events at the times of the box that hears of them: by shared time, or as if they had been sent just
/// now where the clocks of both boxes differ too much.
/// @throws std::runtime_error with one sentence
std::vector<InputEvent> touches_from_json(std::string_view text, const BoxMoment& heard);

}  // namespace vitrine::player
