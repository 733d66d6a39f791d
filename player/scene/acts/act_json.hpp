#pragma once

#include "player/scene/acts/wall_act.hpp"

#include <string>
#include <string_view>

namespace vitrine::player {

/// The longest text that is read as an act, bytes.
constexpr std::size_t max_act_bytes = std::size_t{1} << 20;

/// An act as one line of JSON. Every number is read again as the same bits.
std::string to_json(const WallAct& act);

/// Reads an act. All of it is checked, so that it can be drawn at any time whatever the text holds.
/// @throws std::runtime_error with one sentence, also for an act of another version
WallAct act_from_json(std::string_view text);

}  // namespace vitrine::player
