#pragma once

#include "player/input/contact.hpp"

#include <chrono>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine::player {

/// The touches of visitors on a box that follows, for the leader: fingers and wheels, canvas px.
std::string touches_to_json(std::span<const InputEvent> events);

/// @param now  the time of the events
/// @throws std::runtime_error with one sentence
std::vector<InputEvent> touches_from_json(std::string_view text, std::chrono::nanoseconds now);

}  // namespace vitrine::player
