#pragma once

#include <filesystem>

namespace vitrine {

// How large the player's screens are, for the analyzer, which makes clips no larger than they will be shown:
// docs/catalogue.md.

/// The longest side of the largest canvas that has been shown on, px; 0: not known yet.
/// @param state  the state directory
int noted_screen_side(const std::filesystem::path& state);

/// @throws std::system_error where it cannot be written
void note_screen_side(const std::filesystem::path& state, int side);

}  // namespace vitrine
