#pragma once

#include <filesystem>

namespace vitrine {

// The player notes the size of its screens. The analyzer makes clips of films in a size that suits them:
// docs/catalogue.md, "The store".

/// The longest side of the player's screens when it last had any, px; 0: there is no valid note.
/// @param state  the state directory
int noted_screen_side(const std::filesystem::path& state);

/// Writes the longest side, px. @throws std::system_error
void note_screen_side(const std::filesystem::path& state, int side);

}  // namespace vitrine
