#pragma once

#include "player/display/display.hpp"

#include <memory>

namespace vitrine::player {

/// The opener of the display that `output.screen` names: a kind of the table in display_kinds.cpp with its
/// argument, such as "kms:/dev/dri/card1". Call it once, before any thread starts (service::held()).
/// @throws std::invalid_argument saying what is allowed
std::unique_ptr<DisplayOpener> make_display_opener(const DisplayRequest& request);

}  // namespace vitrine::player
